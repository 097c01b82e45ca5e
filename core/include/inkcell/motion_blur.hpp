// Motion blur: coverage averaged along the path of a moving glyph.
//
//   const MotionBlur blur({x, y});
//   style.set_effect(blur);
//
// The path is divided into steps of at most one pixel along an axis. Coverage
// is the mean of 2 `steps` + 1 plain pictures along the path, drawn by the
// style's filter, whatever it is. Costs 6 times the instructions of plain
// drawing for 3 px, up to 65 pictures for 32 px; and two more bytes of RAM a
// pixel of a band, so that a glyph takes more bands.
#pragma once

#include <stdint.h>

#include "inkcell/effect.hpp"
#include "inkcell/geometry.hpp"

namespace inkcell {

/// The blur of a glyph that moves by `path` during the exposure, from half of
/// it before the glyph's origin to half of it after.
struct MotionBlur : Effect {
  /// The longest path along an axis. [px]
  static constexpr Q26_6 kMost = Q26_6::from_int(32);

  /// Each axis of the path is clamped to kMost.
  constexpr explicit MotionBlur(Point path = {}) noexcept
      : Effect(detail::kMotionBlurMixer),
        steps(static_cast<uint8_t>(steps_of(path))),
        right_q10(limited(path.x) * 16 / steps),
        up_q10(-limited(path.y) * 16 / steps) {}

  uint8_t steps;
  int32_t right_q10;  // a step of the path [px]
  int32_t up_q10;

 private:
  static constexpr int32_t limited(Q26_6 px) noexcept {
    return detail::clamp(px.raw, -kMost.raw, kMost.raw);
  }
  static constexpr int32_t steps_of(Point path) noexcept {
    const int32_t x = limited(path.x);
    const int32_t y = limited(path.y);
    const int32_t right = x < 0 ? -x : x;
    const int32_t down = y < 0 ? -y : y;
    const int32_t longer = right > down ? right : down;
    return longer <= 64 ? 1 : (longer + 63) >> 6;
  }
};

}  // namespace inkcell
