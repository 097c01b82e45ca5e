// Chords stay within the stated bound of their curves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "glyph_outlines.hpp"
#include "shape/flatten.hpp"

namespace inkcell::gen {
namespace test {
namespace {

double to_chord(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  double t = length2 > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2 : 0;
  t = std::min(1.0, std::max(0.0, t));
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

Segment random_curve(Segment::Kind kind, double size, std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-size, size);
  Segment segment;
  segment.kind = kind;
  for (Point& p : segment.p) {
    p = {coordinate(random), coordinate(random)};
  }
  return segment;
}

// The largest distance of points on the curve from their chord.
double deviation(const Segment& segment) {
  const int chords = chord_count(segment);
  double worst = 0;
  for (int chord = 0; chord < chords; ++chord) {
    const double t0 = static_cast<double>(chord) / chords;
    const double t1 = static_cast<double>(chord + 1) / chords;
    for (int k = 1; k < 8; ++k) {
      worst = std::max(worst,
                       to_chord(point_on(segment, t0 + (t1 - t0) * k / 8),
                                point_on(segment, t0), point_on(segment, t1)));
    }
  }
  return worst;
}

TEST(Flatten, CurvesStayWithinTheBound) {
  std::mt19937 random(1);
  double worst = 0;
  for (const double size : {0.01, 1.0, 30.0, 500.0, 10000.0}) {
    for (int i = 0; i < 100; ++i) {
      for (const Segment::Kind kind :
           {Segment::Kind::quadratic, Segment::Kind::cubic}) {
        const double d = deviation(random_curve(kind, size, random));
        EXPECT_LE(d, kFlatteningBound);
        worst = std::max(worst, d);
      }
    }
  }
  // The bound is used up, not only kept.
  EXPECT_GT(worst, kFlatteningBound / 2);
}

TEST(Flatten, StraightCurvesNeedOneChord) {
  Segment segment;
  segment.p[1] = {100, 50};
  EXPECT_EQ(chord_count(segment), 1);
  segment.kind = Segment::Kind::quadratic;
  segment.p[1] = {50, 25};
  segment.p[2] = {100, 50};
  EXPECT_EQ(chord_count(segment), 1);
}

TEST(Flatten, PolygonsComeBackAsTheyAre) {
  const std::vector<Point> points = flatten(rectangle(0, 0, 30, 20));
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[2].x, 30);
  EXPECT_EQ(points[2].y, 20);
}

TEST(Flatten, GapsAreClosedByLines) {
  Contour contour;
  contour.segments.resize(2);
  contour.segments[0].p[1] = {10, 0};
  contour.segments[1].p[0] = {10, 10};
  contour.segments[1].p[1] = {0, 10};
  EXPECT_EQ(flatten(contour).size(), 4u);
}

TEST(Flatten, RepeatedPointsAreDropped) {
  EXPECT_EQ(flatten(polygon({{5, 5}, {5, 5}, {5, 5}})).size(), 1u);
  EXPECT_EQ(flatten(polygon({{0, 0}, {0, 0}, {9, 0}, {9, 9}, {9, 9}})).size(),
            3u);
  EXPECT_TRUE(flatten(Contour()).empty());
}

TEST(Flatten, RefusesCoordinatesThatAreNone) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), -1e300,
                           kCoordinateLimit + 1}) {
    try {
      flatten(polygon({{0, 0}, {10, bad}, {10, 10}}));
      FAIL() << bad;
    } catch (const GeometryError& error) {
      EXPECT_EQ(error.kind(), GeometryError::Kind::bad_coordinates);
    }
  }
}

}  // namespace
}  // namespace test
}  // namespace inkcell::gen
