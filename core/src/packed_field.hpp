// The numbers of new fields: what the packed coding's steps stand for.
#pragma once

#include <stdint.h>

#include "inkcell/packed.hpp"

namespace inkcell {
namespace detail {

inline constexpr uint32_t kQuarterLog2 = 8;
inline constexpr uint32_t kQuarterSteps = 1 << kQuarterLog2;

// A quarter of a sine wave. [Q15]
struct Sines {
  uint16_t q15[kQuarterSteps + 1];
};

// The Taylor series with integers: terms above 2^-30 are all it takes.
constexpr Sines make_sines() noexcept {
  constexpr int64_t kHalfTurnQ30 = 3373259426;  // pi
  Sines sines = {};
  for (uint32_t i = 0; i <= kQuarterSteps; ++i) {
    const int64_t x = (kHalfTurnQ30 * i) >> (kQuarterLog2 + 1);
    const int64_t square = (x * x) >> 30;
    int64_t term = x;
    int64_t sum = x;
    for (int64_t n = 2; n < 20; n += 2) {
      term = -((term * square) >> 30) / (n * (n + 1));
      sum += term;
    }
    sines.q15[i] = static_cast<uint16_t>((sum + (1 << 14)) >> 15);
  }
  return sines;
}

inline constexpr Sines kSines = make_sines();
static_assert(kSines.q15[kQuarterSteps] == 1 << 15, "sine of a quarter turn");

// A unit vector. [Q14]
struct Normal {
  int32_t x;
  int32_t y;
};

inline constexpr uint32_t kFractionBits = 14 - kQuarterLog2;

// On the way from one sine to the next. [Q15 -> Q14, rounded]
inline int32_t between_q14(int32_t from,
                           int32_t to,
                           int32_t fraction) noexcept {
  return (from * (1 << kFractionBits) + (to - from) * fraction +
          (1 << kFractionBits)) >>
         (kFractionBits + 1);
}

// A direction between those of the table. Few are: not part of its callers,
// whose registers it needs. In the first quarter, i + 1 is at most its end.
__attribute__((noinline)) inline void normal_between(uint32_t i,
                                                     int32_t fraction,
                                                     Normal& n) noexcept {
  const uint16_t* up = kSines.q15 + i;
  const uint16_t* down = kSines.q15 + kQuarterSteps - i;
  n = {between_q14(down[0], down[-1], fraction),
       between_q14(up[0], up[1], fraction)};
}

// The direction of 2^-16 turns; each component is off by less than 1.
inline Normal normal_of(uint32_t turn) noexcept {
  const uint32_t along = turn & ((1 << 14) - 1);
  const uint32_t i = along >> kFractionBits;
  const auto fraction =
      static_cast<int32_t>(along & ((1 << kFractionBits) - 1));
  Normal n = {(kSines.q15[kQuarterSteps - i] + 1) >> 1,
              (kSines.q15[i] + 1) >> 1};
  if (fraction != 0) {
    Normal between;
    normal_between(i, fraction, between);
    n = between;
  }
  if ((turn & 1 << 14) != 0) {
    n = {-n.y, n.x};
  }
  if ((turn & 1 << 15) != 0) {
    n = {-n.x, -n.y};
  }
  return n;
}

inline int16_t clamp_i16(int32_t value) noexcept {
  if (value < INT16_MIN) {
    return INT16_MIN;
  }
  return static_cast<int16_t>(value > INT16_MAX ? INT16_MAX : value);
}

// Products and sums that may wrap.
inline uint32_t wrapped_product(int32_t a, int32_t b) noexcept {
  return static_cast<uint32_t>(a) * static_cast<uint32_t>(b);
}

// Where the distance of a new field is stated. [u]
struct Anchor {
  int32_t x_u;
  int32_t y_u;
};

// The offset of a field whose distance at the anchor is `d0` steps.
inline int16_t offset_q4(int32_t d0,
                         const PackedCoding& coding,
                         const Normal& n,
                         const Anchor& anchor) noexcept {
  // 1/64 u are 256 in Q14.
  const uint32_t d0_q14 = wrapped_product(d0, coding.d0_step * 256);
  const uint32_t dot_q14 =
      wrapped_product(n.x, anchor.x_u) + wrapped_product(n.y, anchor.y_u);
  return clamp_i16(static_cast<int32_t>(d0_q14 - dot_q14 + 512) >> 10);
}

// How far along the field its bend is at its anchor.
inline int16_t along_q4(const Normal& n, const Anchor& anchor) noexcept {
  const uint32_t cross_q14 =
      wrapped_product(n.x, anchor.y_u) - wrapped_product(n.y, anchor.x_u);
  return clamp_i16(static_cast<int32_t>(512 - cross_q14) >> 10);
}

// Half the curvature of `bend` steps, 2^19 at most, each of which is a sagitta
// in the middle of a chord of the square's width, or of 64 u in smaller ones.
inline int16_t curvature(int32_t bend,
                         const PackedCoding& coding,
                         uint32_t log2) noexcept {
  const int32_t steps = bend * coding.bend_step;
  const int32_t shift = 15 - 2 * static_cast<int32_t>(log2 < 6 ? 6 : log2);
  const int32_t k = shift >= 0 ? steps * (1 << shift)
                               : (steps + (1 << (-shift - 1))) >> -shift;
  constexpr uint32_t kMost = INT16_MAX;
  if (static_cast<uint32_t>(k) + kMost > 2 * kMost) {
    return k < 0 ? -INT16_MAX : INT16_MAX;
  }
  return static_cast<int16_t>(k);
}

}  // namespace detail
}  // namespace inkcell
