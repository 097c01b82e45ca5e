// Fields fitted to distances that are known in closed form.
#include <gtest/gtest.h>

#include "edges/fit.hpp"

#include <cmath>
#include <functional>
#include <random>

namespace inkcell {
namespace gen {
namespace test {
namespace {

constexpr double kPi = 3.14159265358979323846;

// A lattice of 9 x 9 points around the anchor.
std::vector<FitPoint> lattice(
    double half, const std::function<double(double, double)>& distance) {
  std::vector<FitPoint> points;
  for (int j = -4; j <= 4; ++j) {
    for (int i = -4; i <= 4; ++i) {
      const double x = i * half / 4;
      const double y = j * half / 4;
      const double d = distance(x, y);
      points.push_back({x, y, d, d - 1, d + 1});
    }
  }
  return points;
}

double angle_between(double a, double b) {
  return std::fabs(std::remainder(a - b, 2 * kPi));
}

TEST(FieldFit, LinesAreExact) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 300; ++i) {
    const double angle = kPi * any(random);
    const double d0 = 100 * any(random);
    const std::vector<FitPoint> points = lattice(40, [&](double x, double y) {
      return d0 + std::cos(angle) * x + std::sin(angle) * y;
    });
    for (const bool curved : {false, true}) {
      PrimitiveFit fit;
      ASSERT_TRUE(fit_field(points, curved, fit));
      EXPECT_NEAR(fit.d0, d0, 1e-6);
      EXPECT_LE(angle_between(fit.angle, angle), 1e-8);
      EXPECT_NEAR(fit.k, 0, 1e-8);
    }
  }
}

TEST(FieldFit, AxisDirectionsAreExact) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double angle = quarter * kPi / 2;
    const std::vector<FitPoint> points = lattice(16, [&](double x, double y) {
      return 3 + std::cos(angle) * x + std::sin(angle) * y;
    });
    PrimitiveFit fit;
    ASSERT_TRUE(fit_field(points, true, fit));
    EXPECT_LE(angle_between(fit.angle, angle), 1e-8);
    EXPECT_NEAR(fit.d0, 3, 1e-8);
  }
}

TEST(FieldFit, SecondOrderFieldsAreExact) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 300; ++i) {
    const double angle = kPi * any(random);
    const double d0 = 30 * any(random);
    const double k = any(random) / 100;
    const std::vector<FitPoint> points = lattice(40, [&](double x, double y) {
      const double nx = std::cos(angle);
      const double ny = std::sin(angle);
      const double v = nx * y - ny * x;
      return d0 + nx * x + ny * y + 0.5 * k * v * v;
    });
    PrimitiveFit fit;
    ASSERT_TRUE(fit_field(points, true, fit));
    EXPECT_NEAR(fit.d0, d0, 1e-4);
    EXPECT_LE(angle_between(fit.angle, angle), 1e-5);
    EXPECT_NEAR(fit.k, k, 1e-6);
  }
}

// The level line through the anchor has the anchor's radius.
TEST(FieldFit, CirclesAreMetToSecondOrder) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 1);
  for (int i = 0; i < 200; ++i) {
    const double radius = 60 + 400 * any(random);
    const double way = 2 * kPi * any(random);  // from the centre to the anchor
    const double ink = i % 2 == 0 ? 1 : -1;    // a disk, or a hole
    const double offset = 10 * any(random) - 5;
    const double rho = radius + offset;
    const std::vector<FitPoint> points = lattice(12, [&](double x, double y) {
      return ink * (radius - std::hypot(x + rho * std::cos(way),
                                        y + rho * std::sin(way)));
    });
    PrimitiveFit fit;
    ASSERT_TRUE(fit_field(points, true, fit));
    EXPECT_NEAR(fit.k, -ink / rho, 0.1 / rho) << radius;
    // The term of third order, half across.
    EXPECT_NEAR(fit.d0, -ink * offset, 0.5 * 12 * 12 * 12 / (rho * rho));
    EXPECT_LE(angle_between(fit.angle, ink > 0 ? way + kPi : way), 0.01);
  }
}

TEST(FieldFit, StraightFitsStayStraight) {
  const std::vector<FitPoint> points = lattice(
      20, [](double x, double y) { return 200 - std::hypot(x - 200, y); });
  PrimitiveFit fit;
  ASSERT_TRUE(fit_field(points, false, fit));
  EXPECT_NEAR(fit.k, 0, 1e-12);
  EXPECT_LE(angle_between(fit.angle, 0), 0.02);
}

TEST(FieldFit, FixedAngleIsKept) {
  const std::vector<FitPoint> points =
      lattice(20, [](double x, double y) { return 5 + x * 0.8 + y * 0.6; });
  for (const bool curved : {false, true}) {
    PrimitiveFit fit;
    fit.angle = std::atan2(0.6, 0.8) + 0.01;
    fit.k = 0.5;
    fit_at_angle(points, curved, fit);
    EXPECT_EQ(fit.angle, std::atan2(0.6, 0.8) + 0.01);
    EXPECT_NEAR(fit.d0, 5, 0.3);
    EXPECT_NEAR(fit.k, 0, 0.01);
  }
}

// A point whose leeway is small weighs more.
TEST(FieldFit, ErrorsGoWhereThereIsLeeway) {
  std::vector<FitPoint> points =
      lattice(20, [](double x, double) { return x + (x > 0 ? 1 : 0); });
  for (FitPoint& p : points) {
    const double way = p.x > 0 ? 10 : 0.1;
    p.low = p.d - way;
    p.high = p.d + way;
  }
  PrimitiveFit fit;
  ASSERT_TRUE(fit_field(points, false, fit));
  EXPECT_NEAR(fit.d0, 0, 0.1);
}

TEST(FieldFit, RefusesTooFewPoints) {
  PrimitiveFit fit;
  fit.d0 = 77;
  std::vector<FitPoint> points;
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(fit_field(points, true, fit)) << i;
    points.push_back({static_cast<double>(i), static_cast<double>(i * i),
                      static_cast<double>(i), i - 1.0, i + 1.0});
  }
  EXPECT_EQ(fit.d0, 77);
  EXPECT_TRUE(fit_field(points, false, fit));
}

TEST(FieldFit, RefusesWhatIsNoField) {
  PrimitiveFit fit;
  fit.d0 = 77;
  // Flat; on a ridge.
  EXPECT_FALSE(
      fit_field(lattice(20, [](double, double) { return 9.0; }), true, fit));
  EXPECT_FALSE(fit_field(
      lattice(20, [](double x, double) { return -std::fabs(x); }), true, fit));
  EXPECT_EQ(fit.d0, 77);
}

// All points on a line along the normal or across it, or in one place: either
// way no numbers that are none.
TEST(FieldFit, DegenerateInputGivesFiniteNumbers) {
  for (const bool along : {true, false}) {
    for (const bool curved : {true, false}) {
      std::vector<FitPoint> points;
      for (int i = -5; i <= 5; ++i) {
        const double d = along ? i : 0;
        points.push_back({along ? i : 0.0, along ? 0.0 : i, d, d - 1, d + 1});
      }
      PrimitiveFit fit;
      if (fit_field(points, curved, fit)) {
        EXPECT_TRUE(std::isfinite(fit.d0 + fit.angle + fit.k));
      }
      fit_at_angle(points, curved, fit);
      EXPECT_TRUE(std::isfinite(fit.d0 + fit.angle + fit.k));
    }
  }
  PrimitiveFit fit;
  fit_field(std::vector<FitPoint>(9, {1, 2, 3, 2, 4}), true, fit);
  EXPECT_TRUE(std::isfinite(fit.d0 + fit.angle + fit.k));
  fit_at_angle({}, true, fit);
  EXPECT_TRUE(std::isfinite(fit.d0 + fit.angle + fit.k));
}

}  // namespace
}  // namespace test
}  // namespace gen
}  // namespace inkcell
