// Grid fitting of outlines: points that give way to the grid of pixels.
#pragma once

#include <stdint.h>

#include "outlines/screen_point.hpp"
#include "rows/outline_open.hpp"

namespace inkcell {
namespace detail {

// Moves points of a glyph that is fitted.
void warp_points(const OpenGlyph& opened,
                 ScreenPoint* points,
                 const ScreenPoint* end) noexcept;

}  // namespace detail
}  // namespace inkcell
