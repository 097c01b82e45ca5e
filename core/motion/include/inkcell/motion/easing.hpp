// Easing curves.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"

namespace inkcell::motion {

/// A map of progress to progress. Made by the functions below.
struct Easing {
  enum class Kind : uint8_t { linear, bezier, bounce, steps };

  Kind kind = Kind::linear;
  uint8_t steps = 0;
  int16_t x1_q14 = 0;  // of the Bezier curve's control points
  int16_t y1_q14 = 0;
  int16_t x2_q14 = 0;
  int16_t y2_q14 = 0;
};

/// cubic-bezier() of CSS, in thousandths: a curve from (0, 0) to (1, 1), x is
/// time. x1 and x2 are clamped to 0..1000, y1 and y2 to -1999..1999. With y
/// outside of 0..1000 the result overshoots 0..1.
constexpr Easing cubic_bezier(int32_t x1,
                              int32_t y1,
                              int32_t x2,
                              int32_t y2) noexcept {
  const auto q14 = [](int32_t value, int32_t low, int32_t high) {
    const int32_t clamped = value < low ? low : value > high ? high : value;
    return static_cast<int16_t>(clamped * 16384 / 1000);
  };
  return {Easing::Kind::bezier, 0,
          q14(x1, 0, 1000),     q14(y1, -1999, 1999),
          q14(x2, 0, 1000),     q14(y2, -1999, 1999)};
}

/// `count` equal jumps, 1 to 255, each at the end of its interval.
constexpr Easing steps(uint8_t count) noexcept {
  return {Easing::Kind::steps, count, 0, 0, 0, 0};
}

// The named curves of CSS.
inline constexpr Easing kLinear;
inline constexpr Easing kEase = cubic_bezier(250, 100, 250, 1000);
inline constexpr Easing kEaseIn = cubic_bezier(420, 0, 1000, 1000);
inline constexpr Easing kEaseOut = cubic_bezier(0, 0, 580, 1000);
inline constexpr Easing kEaseInOut = cubic_bezier(420, 0, 580, 1000);
/// Keeps the first value until the end.
inline constexpr Easing kHold = steps(1);
/// Fast, then slow: for things that enter.
inline constexpr Easing kArrive = cubic_bezier(160, 1000, 300, 1000);
/// Slow, then fast: for things that leave.
inline constexpr Easing kLeave = cubic_bezier(700, 0, 840, 0);
/// Overshoots by a tenth.
inline constexpr Easing kOvershoot = cubic_bezier(340, 1560, 640, 1000);
/// Moves back before it starts.
inline constexpr Easing kAnticipate = cubic_bezier(360, 0, 660, -560);
/// Falls and bounces three times.
inline constexpr Easing kBounce = {Easing::Kind::bounce, 0, 0, 0, 0, 0};

/// The eased progress, 0 at 0 and 1 at 1. `progress` is clamped to 0..1.
/// A Bezier curve costs about 200 instructions: x is found by bisection, which
/// ends after 16 steps whatever the numbers.
Q16_16 ease(const Easing& easing, Q16_16 progress) noexcept;

}  // namespace inkcell::motion
