#include "edges/code.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "shape/points.hpp"

namespace inkcell {
namespace gen {
namespace {

// Steps in e0, that of the angle so far from the anchor. Coarser ones make more
// cells and little less bytes; of finer ones that of the distance pays best.
constexpr double kDistanceStep = 0.25;
constexpr double kAngleStep = 0.5;
constexpr double kAngleReach_u = 24;
constexpr double kBendStep = 0.75;

// Golomb-Rice parameters of levels 0 to 3 at an e0 of 1 u: bits below the unary
// part.
constexpr int kBendBits[] = {4, 3, 2, 2};
constexpr int kMostBendBits = 6;

// Longer unary parts of a bend are not tried.
constexpr int kUnaryLimit = 16;

constexpr int kMostBits = 16;

constexpr int kQuarterLog2 = 8;
constexpr int kQuarterSteps = 1 << kQuarterLog2;
constexpr int kFractionBits = 14 - kQuarterLog2;

// Bends of small squares are small: 3 for all below 64 u.
size_t level_of(int log2) {
  return static_cast<size_t>(std::clamp(8 - log2, 0, 3));
}

int whole(double value, int least, int most) {
  return std::clamp(static_cast<int>(std::lround(value)), least, most);
}

// A quarter of a sine wave. [Q15]
using Sines = std::array<int32_t, kQuarterSteps + 1>;

// The Taylor series with integers: the same on every machine. Terms above 2^-30
// are all it takes.
constexpr Sines make_sines() {
  constexpr int64_t kHalfTurnQ30 = 3373259426;  // pi
  Sines sines = {};
  for (int i = 0; i <= kQuarterSteps; ++i) {
    const int64_t x = (kHalfTurnQ30 * i) >> (kQuarterLog2 + 1);
    const int64_t square = (x * x) >> 30;
    int64_t term = x;
    int64_t sum = x;
    for (int64_t n = 2; n < 20; n += 2) {
      term = -((term * square) >> 30) / (n * (n + 1));
      sum += term;
    }
    sines[static_cast<size_t>(i)] =
        static_cast<int32_t>((sum + (1 << 14)) >> 15);
  }
  return sines;
}

constexpr Sines kSines = make_sines();
static_assert(kSines[kQuarterSteps] == 1 << 15, "sine of a quarter turn");

// A unit vector. [Q14]
struct Normal {
  int32_t x;
  int32_t y;
};

// A fraction of the step from one sine to the next. [Q15 -> Q14, rounded]
int32_t between_q14(int32_t from, int32_t to, int32_t fraction) {
  return (from * (1 << kFractionBits) + (to - from) * fraction +
          (1 << kFractionBits)) >>
         (kFractionBits + 1);
}

// The direction of 2^-16 turns; each component is off by less than 1.
Normal normal_of(uint32_t turn) {
  const uint32_t along = turn & ((1 << 14) - 1);
  const size_t up = along >> kFractionBits;
  const size_t down = kQuarterSteps - up;
  const auto fraction =
      static_cast<int32_t>(along & ((1 << kFractionBits) - 1));
  Normal n = {(kSines[down] + 1) >> 1, (kSines[up] + 1) >> 1};
  if (fraction != 0) {
    n = {between_q14(kSines[down], kSines[down - 1], fraction),
         between_q14(kSines[up], kSines[up + 1], fraction)};
  }
  if ((turn & 1 << 14) != 0) {
    n = {-n.y, n.x};
  }
  if ((turn & 1 << 15) != 0) {
    n = {-n.x, -n.y};
  }
  return n;
}

// Half the curvature of `bend` steps, each of which is a sagitta in the middle
// of a chord of the square's width, or of 64 u in smaller ones.
int16_t curvature(int bend, const PrimitiveSteps& steps, int log2) {
  const int sagitta = bend * steps.bend_step;
  const int shift = 15 - 2 * std::max(log2, 6);
  const int k = shift >= 0 ? sagitta * (1 << shift)
                           : (sagitta + (1 << (-shift - 1))) >> -shift;
  return static_cast<int16_t>(std::clamp(k, -INT16_MAX, INT16_MAX));
}

// From Q14 to Q4, rounded and clamped.
int16_t to_q4(int64_t value_q14) {
  return static_cast<int16_t>(
      std::clamp<int64_t>((value_q14 + 512) >> 10, INT16_MIN, INT16_MAX));
}

}  // namespace

int PrimitiveSteps::d0_bits(int log2) const {
  return std::min(d0_base + std::max(log2 - d0_log2, 0), kMostBits);
}

int PrimitiveSteps::angle_bits(int log2) const {
  return std::min(angle_base + std::max(log2 - 5, 0), kMostBits);
}

int PrimitiveSteps::bend_bits(int bend, int log2) const {
  const int low = bend_low[level_of(log2)];
  return 2 + low + ((std::abs(bend) - 1) >> low);
}

int PrimitiveSteps::most_bend(int log2) const {
  return kUnaryLimit << bend_low[level_of(log2)];
}

int PrimitiveSteps::quantised_d0(double d0_u, int log2) const {
  const int most = 1 << (d0_bits(log2) - 1);
  return whole(d0_u * 64 / d0_step, -most, most - 1);
}

double e0_u(const Target& options) {
  return options.tolerance / 255 * 1024 / options.max_px;
}

PrimitiveSteps steps_for(const Target& options) {
  const double e0 = e0_u(options);
  PrimitiveSteps steps;
  steps.d0_step = whole(64 * kDistanceStep * e0, 1, 255);
  steps.bend_step = whole(64 * kBendStep * e0, 1, 255);
  steps.d0_log2 = whole(std::ceil(std::log2(band_u(options))), 4, 8);
  const double range = 2 * std::ldexp(64.0, steps.d0_log2) / steps.d0_step;
  steps.d0_base = whole(std::ceil(std::log2(range)), 4, kMostBits);
  const double turn = 2 * kPi * kAngleReach_u / (kAngleStep * e0);
  steps.angle_base = whole(std::log2(turn), 4, 10);
  for (size_t level = 0; level < 4; ++level) {
    steps.bend_low[level] =
        whole(kBendBits[level] - std::log2(e0), 0, kMostBendBits);
  }
  return steps;
}

PrimitiveNumbers field_numbers(const PrimitiveCode& code,
                               const PrimitiveSteps& steps,
                               int log2,
                               int x_u,
                               int y_u) {
  const int angle_bits = has_angle(code.kind) ? steps.angle_bits(log2) : 2;
  const Normal n = normal_of(code.angle << (16 - angle_bits));
  // 1/64 u are 256 in Q14.
  const int64_t d0_q14 = int64_t{code.d0} * steps.d0_step * 256;
  PrimitiveNumbers field;
  field.nx_q14 = static_cast<int16_t>(n.x);
  field.ny_q14 = static_cast<int16_t>(n.y);
  field.c_q4 = to_q4(d0_q14 - (int64_t{n.x} * x_u + int64_t{n.y} * y_u));
  if (is_bent(code.kind)) {
    field.bend = curvature(code.bend, steps, log2);
  }
  if (field.bend != 0) {
    field.along_q4 = to_q4(int64_t{n.y} * x_u - int64_t{n.x} * y_u);
  }
  return field;
}

}  // namespace gen
}  // namespace inkcell
