// Grid fitting of outlines: points that give way to the grid of pixels.
#pragma once

#include <stdint.h>

#include "inkcell/glyph_warp.hpp"
#include "outlines/outline_glyph.hpp"
#include "outlines/screen_point.hpp"
#include "rows/outline_mixer.hpp"

namespace inkcell {
namespace detail {

// Moves points of a glyph, whose samples are those of `plan`.
void warp_points(const GlyphWarp& warp,
                 const OutlineGlyph& glyph,
                 const OutlinePlan& plan,
                 ScreenPoint* points,
                 const ScreenPoint* end) noexcept;

}  // namespace detail
}  // namespace inkcell
