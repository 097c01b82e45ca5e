// The steps of a font's primitives, and what they cost.
#include <gtest/gtest.h>

#include "edges/code.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "edge_target.hpp"
#include "edges/model.hpp"

namespace inkcell {
namespace gen {
namespace test {
namespace {

// From coarse to as fine as it goes.
const std::vector<Target> kRanges = {
    edge_target(4, 4, 255),   edge_target(4, 1024, 1),
    edge_target(8, 64, 16),   edge_target(12, 32, 36),
    edge_target(8, 128, 8),   edge_target(1024, 1024, 1),
    edge_target(40, 40, 100), edge_target(4, 8, 1)};

// Half of 1/255 of the tolerance at 64 px is 32 u / 255.
TEST(PrimitiveCode, ToleranceIsADistanceAtTheLargestSize) {
  EXPECT_DOUBLE_EQ(e0_u(edge_target(8, 64, 16)), 16.0 / 255 * 16);
  EXPECT_DOUBLE_EQ(e0_u(edge_target(8, 1024, 255)), 1);
}

// A distance up to the band is met to half a step, with no step above the
// distance that the tolerance allows unless the format has no finer one.
TEST(PrimitiveCode, DistancesAreMetToHalfAStep) {
  std::mt19937 random(14);
  for (const Target& options : kRanges) {
    const PrimitiveSteps steps = steps_for(options);
    EXPECT_LE(steps.d0_step / 64.0, std::max(e0_u(options), 1 / 64.0));
    for (int log2 = 1; log2 <= 12; ++log2) {
      const double reach =
          std::min<double>(std::ldexp(1, std::max(log2 - 1, 5)), 512);
      std::uniform_real_distribution<double> any(-reach, 0.99 * reach);
      const double half = steps.d0_step / 128.0;
      const int most = 1 << (steps.d0_bits(log2) - 1);
      if (most * 2 * half < reach) {
        continue;  // 16 bits do not reach farther
      }
      for (int i = 0; i < 200; ++i) {
        const double d0 = any(random);
        const int count = steps.quantised_d0(d0, log2);
        EXPECT_NEAR(count * 2 * half, d0, half + 1e-9);
      }
      EXPECT_EQ(steps.quantised_d0(1e6, log2), most - 1);
      EXPECT_EQ(steps.quantised_d0(-1e6, log2), -most);
    }
  }
}

// What a code says, in real numbers, is what its field says.
TEST(PrimitiveCode, FieldsAreWhatTheCodesSay) {
  constexpr double kPi = 3.14159265358979323846;
  std::mt19937 random(15);
  const auto between = [&](int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random);
  };
  for (size_t round = 0; round < 20000; ++round) {
    const PrimitiveSteps steps = steps_for(kRanges[round % kRanges.size()]);
    const int log2 = between(1, 8);
    const int x = between(-1200, 1200);  // |c| and |cw| stay below 2048 u
    const int y = between(-1200, 1200);
    PrimitiveCode code;
    code.kind = static_cast<PrimitiveKind>(between(0, 3));
    const int most =
        std::min(1 << (steps.d0_bits(log2) - 1), 200 * 64 / steps.d0_step);
    code.d0 = between(-most, most - 1);
    const int turn = has_angle(code.kind) ? steps.angle_bits(log2) : 2;
    code.angle = static_cast<uint32_t>(between(0, (1 << turn) - 1));
    const double length =
        std::ldexp(1.0, PrimitiveSteps::bend_length_log2(log2));
    if (is_bent(code.kind)) {
      const int bend =
          std::min(steps.most_bend(log2),
                   static_cast<int>(length / 4 / steps.bend_step * 64));
      code.bend = between(1, std::max(1, bend)) * (between(0, 1) * 2 - 1);
    }
    const Primitive model(field_numbers(code, steps, log2, x, y));
    const double angle = std::ldexp(2.0 * code.angle, -turn) * kPi;
    // The normal is rounded to 2^-14, the offset to 1/16 u.
    EXPECT_NEAR(model.nx, std::cos(angle), 1.5 / 16384);
    EXPECT_NEAR(model.ny, std::sin(angle), 1.5 / 16384);
    EXPECT_NEAR(model.nx * x + model.ny * y + model.c,
                code.d0 * steps.d0_step / 64.0, 1.0 / 32 + 1e-9);
    if (model.k != 0) {
      EXPECT_NEAR(model.nx * y - model.ny * x + model.cw, 0, 1.0 / 32 + 1e-9);
    }
    if (is_bent(code.kind)) {
      EXPECT_NEAR(model.k * length * length, code.bend * steps.bend_step / 64.0,
                  std::ldexp(length * length, -19));
    }
  }
}

TEST(PrimitiveCode, AxesAreExact) {
  constexpr int kExpected[4][2] = {
      {16384, 0}, {0, 16384}, {-16384, 0}, {0, -16384}};
  PrimitiveCode code;
  for (code.angle = 0; code.angle < 4; ++code.angle) {
    const PrimitiveNumbers field =
        field_numbers(code, steps_for(kRanges[2]), 5, 0, 0);
    EXPECT_EQ(field.nx_q14, kExpected[code.angle][0]);
    EXPECT_EQ(field.ny_q14, kExpected[code.angle][1]);
  }
}

TEST(PrimitiveCode, NumbersThatDoNotFitAreClamped) {
  PrimitiveSteps steps;
  steps.d0_step = 255;
  steps.bend_step = 255;
  PrimitiveCode code;
  code.kind = PrimitiveKind::axis_arc;
  for (const int sign : {1, -1}) {
    code.d0 = sign * 32767;
    code.bend = sign * 100000;
    const PrimitiveNumbers field = field_numbers(code, steps, 8, 0, 0);
    EXPECT_EQ(field.c_q4, sign > 0 ? 32767 : -32768);
    EXPECT_EQ(field.bend, sign * 32767);
  }
  // Rounded to no bend at all: a line.
  steps.bend_step = 1;
  code.bend = 1;
  const PrimitiveNumbers line = field_numbers(code, steps, 12, 100, 100);
  EXPECT_EQ(line.bend, 0);
  EXPECT_EQ(line.along_q4, 0);
}

TEST(PrimitiveCode, BendsHaveALimit) {
  for (const Target& options : kRanges) {
    const PrimitiveSteps steps = steps_for(options);
    for (int log2 = 1; log2 <= 8; ++log2) {
      const int most = steps.most_bend(log2);
      EXPECT_GE(most, 16);
      int before = 0;
      for (int bend = 1; bend <= most; ++bend) {
        const int bits = steps.bend_bits(bend, log2);
        EXPECT_EQ(steps.bend_bits(-bend, log2), bits);
        EXPECT_GE(bits, before);
        before = bits;
      }
      // Unary part of 15 ones and a zero, the rest, a sign.
      const int low = steps.bend_low[std::clamp(8 - log2, 0, 3)];
      EXPECT_EQ(before, 16 + low + 1);
    }
  }
}

}  // namespace
}  // namespace test
}  // namespace gen
}  // namespace inkcell
