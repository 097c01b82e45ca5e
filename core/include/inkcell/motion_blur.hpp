// Motion blur: coverage averaged along the path of a moving glyph.
//
//   MotionBlur blur;
//   INKCELL_TRY(make_motion_blur(filter, {x, y}, blur));
//   style.set_effect(motion_blur_effect(blur));
//
// The path is divided into steps of at most one pixel along an axis.
//
// Outlines: the mean of 2 `steps` + 1 plain pictures along the path, drawn by
// the style's filter, whatever it is. Costs 6 times the instructions of plain
// drawing for 3 px, up to 65 pictures for 32 px; and two more bytes of RAM a
// pixel of a band, so that a glyph takes more bands.
//
// Cells: a distance at the ends of each step. Within a step the distance is
// taken as linear, so the filter's ramp integrates in closed form: two table
// look-ups and one division a step. A pixel near the ink costs `steps` + 1
// distances.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text_style.hpp"

namespace inkcell {

/// Options of motion_blur_effect: built once a vector, shared.
struct MotionBlur {
  Filter filter;  // of cells
  /// sums[i] is the sum of the filter's table entries below i.
  uint16_t sums[Filter::kEntries + 1] = {};
  int32_t right_q10 = 0;  // the way of a step [px]
  int32_t up_q10 = 0;
  int32_t length_q10 = 0;  // at least that of a step, at most 1.5 times
  uint8_t steps = 1;
  uint8_t reach_px = 1;  // beyond plain drawing
};

/// The blur of a glyph that moves by `way` during the exposure, from half of it
/// before the glyph's origin to half of it after. bad_argument: `way` exceeds
/// 32 px along an axis.
Status make_motion_blur(const Filter& filter,
                        Point way,
                        MotionBlur& out) noexcept;

namespace detail {
extern const Mixer kMotionBlurMixer;
}  // namespace detail

/// The options must outlive the style.
constexpr Effect motion_blur_effect(const MotionBlur& blur) noexcept {
  return {&detail::kMotionBlurMixer, &blur, blur.reach_px};
}
Effect motion_blur_effect(const MotionBlur&&) = delete;

}  // namespace inkcell
