// Distances on the screen where a style stretches edges differently.
#pragma once

#include <stdint.h>

#include "distance/csg.hpp"
#include "inkcell/text_style.hpp"

namespace inkcell {
namespace detail {

// What such a style needs beside Csg; linked with what names it.
struct Stretching {
  // The values of primitives from which on, on both sides, distances on the
  // screen are not below the reach, or just so. At most kMaxFarQ22. [px]
  int32_t (*far_q22)(const TextStyle& style, int32_t reach_q22) noexcept;
  // The distance of a leaf on the screen at a point. [px, Q22]
  int32_t (*value)(const Csg& csg,
                   PlacedLeaf& leaf,
                   const PixelPlace& at) noexcept;
  // The same of a leaf of samples, given the place in the cell. [u, Q16]
  int32_t (*samples_value)(const Csg& csg,
                           const Leaf& leaf,
                           uint32_t x_q16,
                           uint32_t y_q16) noexcept;
  // The gradient of a primitive as the screen shows it. [Q14]
  Vector (*on_screen)(const Csg& csg, Vector gradient) noexcept;
};

extern const Stretching kStretching;

// Farther than this, 256 px, is far everywhere.
inline constexpr int32_t kMaxFarQ22 = 1 << 30;

}  // namespace detail
}  // namespace inkcell
