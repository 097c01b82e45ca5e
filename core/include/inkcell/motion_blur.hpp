// Type that moves while the shutter is open: coverage along a vector.
//
//   MotionBlur blur;
//   INKCELL_TRY(make_motion_blur(filter, {x, y}, blur));
//   style.set_effect(motion_blur_effect(blur));
//
// The way is cut into steps of at most a pixel, and distances are taken where
// they meet. Within a step the distance changes evenly, so that the filter's
// ramp is integrated in closed form: two look-ups and a division a step. A
// pixel near ink costs one distance more than there are steps.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/render.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text_style.hpp"

namespace inkcell {

/// Options of motion_blur_effect: built once a vector, shared.
struct MotionBlur {
  Filter filter;
  /// What the entries of the filter's table before this one sum up to.
  uint16_t sums[Filter::kEntries + 1] = {};
  int32_t right_q10 = 0;  // the way of a step [px]
  int32_t up_q10 = 0;
  int32_t length_q10 = 0;  // at least that of a step, at most 1.5 times
  uint8_t steps = 1;
  uint8_t reach_px = 1;  // beyond plain drawing
};

/// For a glyph that moves by `way` while it is seen, half of it before and half
/// after its origin. bad_argument: the way is longer than 32 px along an axis.
Status make_motion_blur(const Filter& filter,
                        Point way,
                        MotionBlur& out) noexcept;

namespace detail {
void paint_motion_blur(const GlyphField& field,
                       const TextStyle& style,
                       const void* options,
                       const FinePoint& origin,
                       const Sink& sink);
}  // namespace detail

/// Cells only; glyphs of outlines are drawn as without it. The options must
/// outlive the style.
constexpr Effect motion_blur_effect(const MotionBlur& blur) noexcept {
  return {detail::paint_motion_blur, nullptr, &blur, blur.reach_px};
}
Effect motion_blur_effect(const MotionBlur&&) = delete;

}  // namespace inkcell
