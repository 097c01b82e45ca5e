// Which pixels a painter looks at.
#pragma once

#include <stdint.h>

#include "inkcell/field.hpp"
#include "inkcell/render.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text_style.hpp"

namespace inkcell {
namespace detail {

// From one place to another, in whole px or the like.
struct Stretch {
  int64_t low;
  int64_t high;
};

// Where something may show: the grid, but no farther from the ink than `reach`.
// [u -> px, Q10]
inline Stretch shown(int32_t grid_low_u,
                     int32_t grid_high_u,
                     int32_t ink_low_u,
                     int32_t ink_high_u,
                     int32_t size_q6,
                     int32_t reach_q10) noexcept {
  const auto px_q10 = [size_q6](int32_t u) noexcept {
    return (u * size_q6) >> 6;
  };
  const int32_t ink_low = px_q10(ink_low_u) - reach_q10;
  const int32_t ink_high = px_q10(ink_high_u) + 1 + reach_q10;
  const int32_t low = px_q10(grid_low_u);
  const int32_t high = px_q10(grid_high_u) + 1;
  return {ink_low > low ? ink_low : low, ink_high < high ? ink_high : high};
}

// The pixels of the window whose centres lie where an upright glyph shows
// something, or no farther than `more` from there, to the sides and up and
// down; [px, Q10] of other glyphs those of field_box.
__attribute__((noinline)) inline Rect painted_box(
    const GlyphField& field,
    const TextStyle& style,
    const FinePoint& origin,
    const Rect& window,
    int32_t more_across_q10,
    int32_t more_along_q10) noexcept {
  const Rect box = intersect(field_box(field, style, origin), window);
  if (!style.is_upright()) {
    return box;
  }
  const int32_t size_q6 = style.size().raw;
  const int32_t outside = style.filter().outside_q10;
  const int32_t reach_q10 = outside < 0 ? -outside : 0;
  const InkBox& ink = field.ink;
  const Stretch x =
      shown(field.x0_u, field.x1_u(), ink.x0_u, ink.x1_u, size_q6, reach_q10);
  const Stretch y =
      shown(field.y0_u, field.y1_u(), ink.y0_u, ink.y1_u, size_q6, reach_q10);
  // The first pixel whose centre is not before a place.
  const auto first = [](int64_t place_q10) noexcept {
    constexpr int64_t kFar = int64_t{1} << 30;
    const int64_t pixel = (place_q10 + 511) >> 10;
    return static_cast<int32_t>(pixel < -kFar  ? -kFar
                                : pixel > kFar ? kFar
                                               : pixel);
  };
  return intersect(box, {first(origin.x_q10 + x.low - more_across_q10),
                         first(origin.y_q10 - y.high - more_along_q10),
                         first(origin.x_q10 + x.high + more_across_q10 + 1),
                         first(origin.y_q10 - y.low + more_along_q10 + 1)});
}

}  // namespace detail
}  // namespace inkcell
