// A point of a glyph in px.
#pragma once

#include <stdint.h>

#include "base/modular.hpp"

namespace inkcell {
namespace detail {

// A point of a glyph. [px from the origin, Q8]
struct PixelPlace {
  uint32_t x_q8;
  uint32_t y_q8;
};

// What a primitive is evaluated at, to the nearest. [px, Q20 -> Q8]
inline constexpr int32_t kHalfQ20 = 1 << 11;
inline uint32_t q8_of(uint32_t position_q20) noexcept {
  return static_cast<uint32_t>(wrapped(position_q20) >> 12);
}

}  // namespace detail
}  // namespace inkcell
