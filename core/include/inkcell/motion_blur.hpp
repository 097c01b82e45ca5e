// Motion blur: coverage averaged along the path of a moving glyph.
//
//   MotionBlur blur;
//   INKCELL_TRY(make_motion_blur({x, y}, blur));
//   style.set_effect(motion_blur_effect(blur));
//
// The path is divided into steps of at most one pixel along an axis. Coverage
// is the mean of 2 `steps` + 1 plain pictures along the path, drawn by the
// style's filter, whatever it is. Costs 6 times the instructions of plain
// drawing for 3 px, up to 65 pictures for 32 px; and two more bytes of RAM a
// pixel of a band, so that a glyph takes more bands.
#pragma once

#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"

namespace inkcell {

/// Options of motion_blur_effect: built once a vector, shared.
struct MotionBlur {
  int32_t right_q10 = 0;  // a step of the path [px]
  int32_t up_q10 = 0;
  uint8_t steps = 1;
  uint8_t reach_px = 1;  // beyond plain drawing
};

/// The blur of a glyph that moves by `path` during the exposure, from half of
/// it before the glyph's origin to half of it after. bad_argument: `path`
/// exceeds 32 px along an axis.
Status make_motion_blur(Point path, MotionBlur& out) noexcept;

namespace detail {
extern const Mixer kMotionBlurMixer;
}  // namespace detail

/// The options must outlive the style.
constexpr Effect motion_blur_effect(const MotionBlur& blur) noexcept {
  return {&detail::kMotionBlurMixer, &blur, blur.reach_px};
}
Effect motion_blur_effect(const MotionBlur&&) = delete;

}  // namespace inkcell
