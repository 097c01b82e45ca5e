// Glyphs that do not stand upright: their axes on the screen.
#pragma once

#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/style.hpp"

namespace inkcell::detail {

struct OutlineMap;

// What drawing needs of a style that is not upright. Constructors of Style name
// it, so that upright text does not link it.
struct Slant {
  // From the map of an upright style to that of this one. Returns whether it
  // mirrors.
  bool (*map)(const Style& style, OutlineMap& map) noexcept;
  // From the origin along the baseline and up across it. [px, Q10]
  FinePoint (*place)(const Style& style,
                     const FinePoint& origin,
                     int64_t along_q10,
                     int64_t across_q10) noexcept;
};

}  // namespace inkcell::detail
