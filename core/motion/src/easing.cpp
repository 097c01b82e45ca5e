// Bezier curves by bisection, a bounce of parabolas, and jumps.
#include "inkcell/motion/easing.hpp"

#include "limits.hpp"

namespace inkcell::motion {
namespace {

constexpr int32_t kOneQ14 = 1 << 14;

// One coordinate of a Bezier curve from 0 to 1: ((a s + b) s + c) s.
struct Cubic {
  int32_t a;
  int32_t b;
  int32_t c;

  Cubic(int32_t p1_q14, int32_t p2_q14) noexcept
      : a(kOneQ14 + 3 * p1_q14 - 3 * p2_q14),
        b(3 * p2_q14 - 6 * p1_q14),
        c(3 * p1_q14) {}

  // 0 <= s <= 1. With control points in 0..1 no product reaches 2^31: a s + b
  // is between b and a + b, -6 to 3.
  int32_t at_q14(int32_t s_q14) const noexcept {
    const int32_t inner = ((a * s_q14) >> 14) + b;
    return (((inner * s_q14 >> 14) + c) * s_q14) >> 14;
  }

  // The same with control points in -2..2, in Q16.
  int32_t at_q16(int32_t s_q14) const noexcept {
    const int64_t inner = int64_t{a} * s_q14 + int64_t{b} * kOneQ14;  // [Q28]
    const int64_t outer = (inner * s_q14 >> 14) + int64_t{c} * kOneQ14;
    return static_cast<int32_t>((outer * s_q14 + (1 << 25)) >> 26);
  }
};

Q16_16 ease_bezier(const Easing& easing, int32_t progress_q16) noexcept {
  const Cubic x(easing.x1_q14, easing.x2_q14);
  const Cubic y(easing.y1_q14, easing.y2_q14);
  // The greatest s with x(s) <= progress; x is monotonic.
  const int32_t wanted_q14 = progress_q16 >> 2;
  int32_t s_q14 = 0;
  for (int32_t bit = kOneQ14 >> 1; bit != 0; bit >>= 1) {
    if (x.at_q14(s_q14 + bit) <= wanted_q14) {
      s_q14 += bit;
    }
  }
  return Q16_16::from_raw(y.at_q16(s_q14));
}

// Parabolas: the first is half of one, each later bounce has half the width and
// a quarter of the height of the one before: a ball that loses half its speed.
Q16_16 ease_bounce(int32_t progress_q16) noexcept {
  struct Arc {
    int32_t end_q16;
    int32_t middle_q16;
    int32_t height_q16;
  };
  constexpr int32_t kOne = 65536;
  constexpr Arc kArcs[] = {{kOne * 4 / 11, 0, 0},
                           {kOne * 8 / 11, kOne * 6 / 11, kOne * 3 / 4},
                           {kOne * 10 / 11, kOne * 9 / 11, kOne * 15 / 16},
                           {kOne, kOne * 21 / 22, kOne * 63 / 64}};
  const Arc* arc = kArcs;
  while (progress_q16 >= arc->end_q16 && arc->end_q16 != kOne) {
    ++arc;
  }
  // 121/16 times the square of the distance from the middle, at most 4/11.
  const int32_t offset = progress_q16 - arc->middle_q16;
  const int32_t square_q16 = ((offset >> 1) * (offset >> 1)) >> 14;
  return Q16_16::from_raw(arc->height_q16 + square_q16 * 121 / 16);
}

}  // namespace

Q16_16 ease(const Easing& easing, Q16_16 progress) noexcept {
  if (progress.raw <= 0) {
    return {};
  }
  if (progress.raw >= 1 << 16) {
    return Q16_16::from_int(1);
  }
  switch (easing.kind) {
    case Easing::Kind::bezier:
      return ease_bezier(easing, progress.raw);
    case Easing::Kind::bounce:
      return ease_bounce(progress.raw);
    case Easing::Kind::steps: {
      const int32_t count = easing.steps == 0 ? 1 : easing.steps;
      return Q16_16::from_raw((progress.raw * count >> 16) * (1 << 16) / count);
    }
    default:
      return progress;
  }
}

}  // namespace inkcell::motion
