// Curves for dense points: few, accurate, corners kept.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fit/cubic_fit.hpp"
#include "fit/curve_fitter.hpp"
#include "shape/shape.hpp"
#include "stroke/stroke.hpp"

namespace inkcell::design::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

Loop circle(double radius, int count) {
  Loop loop;
  for (int i = 0; i < count; ++i) {
    const double a = 2 * kPi * i / count;
    loop.points.push_back({radius * std::cos(a), radius * std::sin(a)});
    loop.tangents.push_back({-std::sin(a), std::cos(a)});
  }
  return loop;
}

const std::vector<Point> kSquare = {{0, 0}, {300, 0}, {300, 300}, {0, 300}};

TEST(FitCubic, FindsTheCubicThatThePointsLieOn) {
  gen::Segment truth;
  truth.kind = gen::Segment::Kind::cubic;
  truth.p[0] = {0, 0};
  truth.p[1] = {30, 80};
  truth.p[2] = {140, 90};
  truth.p[3] = {200, -20};
  std::vector<Point> points;
  for (int i = 0; i <= 100; ++i) {
    points.push_back(cubic_at(truth, i / 100.0));
  }
  const std::vector<double> lengths = arc_lengths(points);
  Stretch stretch;
  stretch.points = points.data();
  stretch.lengths = lengths.data();
  stretch.count = points.size();
  EXPECT_LT(fit_cubic(stretch, 0.1).worst, 0.1);
  stretch.begin = unit(truth.p[1] - truth.p[0]);
  stretch.end = unit(truth.p[3] - truth.p[2]);
  const FittedCubic fitted = fit_cubic(stretch, 0.1);
  EXPECT_LT(fitted.worst, 0.1);
  EXPECT_LT(length(fitted.segment.p[1] - truth.p[1]), 2);
}

TEST(FitLoop, ACircleIsFourCubicsWithPointsAtItsExtremes) {
  FitOptions options;
  options.tolerance = 0.25;
  const gen::Contour contour = fit_loop(circle(250, 1500), options);
  ASSERT_EQ(contour.segments.size(), 4u);
  for (const gen::Segment& segment : contour.segments) {
    EXPECT_EQ(segment.kind, gen::Segment::Kind::cubic);
    const Point& at = segment.p[0];
    EXPECT_LT(std::min(std::fabs(at.x), std::fabs(at.y)), 0.6);
    // Horizontal or vertical handles.
    const Point handle = segment.p[1] - at;
    EXPECT_LT(std::min(std::fabs(handle.x), std::fabs(handle.y)), 1e-3);
    for (int i = 0; i <= 20; ++i) {
      EXPECT_NEAR(length(cubic_at(segment, i / 20.0)), 250, 0.25);
    }
  }
}

TEST(FitLoop, ASquareIsFourLines) {
  Loop loop = sample_polygon(kSquare, 1);
  CornerOptions exact;
  exact.is_exact = true;
  find_corners(exact, loop);
  ASSERT_EQ(loop.corners.size(), 4u);
  const gen::Contour contour = fit_loop(loop, FitOptions());
  ASSERT_EQ(contour.segments.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(contour.segments[i].kind, gen::Segment::Kind::line);
    EXPECT_TRUE(same(contour.segments[i].p[0], kSquare[i]));
  }
}

// The points near corners are cut off, as by cells and pixels.
TEST(FindCorners, RestoreThoseThatWereRounded) {
  const Loop sharp = sample_polygon(kSquare, 1);
  Loop loop;
  for (size_t i = 0; i < sharp.points.size(); ++i) {
    bool is_near = false;
    for (const Point& corner : kSquare) {
      is_near = is_near || length(sharp.points[i] - corner) < 1.5;
    }
    if (!is_near) {
      loop.points.push_back(sharp.points[i]);
      loop.tangents.push_back(sharp.tangents[i]);
    }
  }
  CornerOptions options;
  options.reach = 2.5;
  find_corners(options, loop);
  ASSERT_EQ(loop.corners.size(), 4u);
  for (const size_t corner : loop.corners) {
    double nearest = 1e9;
    for (const Point& truth : kSquare) {
      nearest = std::min(nearest, length(loop.points[corner] - truth));
    }
    EXPECT_LT(nearest, 1e-6);
  }
}

TEST(FindCorners, ACircleHasNone) {
  Loop loop = circle(20, 120);
  find_corners(CornerOptions(), loop);
  EXPECT_TRUE(loop.corners.empty());
}

// The corner of two sides at a right angle, rounded by an arc of this radius or
// cut by a line; its tip is the origin, its sides go left and down.
struct Tip {
  double radius = 0;
  Point cut;  // what the line cuts off both sides

  double distance(const Point& p) const {
    if (radius > 0 && p.x > -radius && p.y > -radius) {
      return radius - length(p - Point{-radius, -radius});
    }
    const double straight = std::min(-p.x, -p.y);
    return length(cut) == 0
               ? straight
               : std::min(straight,
                          -(cut.y * p.x + cut.x * p.y + cut.x * cut.y) /
                              length(cut));
  }
};

// A square with one such tip, as fields show it: points on the edge.
Loop square_with(const Tip& tip) {
  std::vector<Point> polygon = {{-200, 0}, {-200, -200}, {0, -200}};
  const auto add = [&](double x, double y) { polygon.push_back({x, y}); };
  if (tip.radius > 0) {
    for (int i = 0; i <= 40; ++i) {
      const double a = kPi / 2 * i / 40;
      add(tip.radius * (std::cos(a) - 1), tip.radius * (std::sin(a) - 1));
    }
  } else if (length(tip.cut) > 0) {
    add(0, -tip.cut.y);
    add(-tip.cut.x, 0);
  } else {
    add(0, 0);
  }
  return sample_polygon(polygon, 0.5);
}

size_t corners_near_tip(const Tip& tip) {
  Loop loop = square_with(tip);
  CornerOptions options;
  options.reach = 2.5;
  options.distance = [&tip](const Point& p) { return tip.distance(p); };
  find_corners(options, loop);
  size_t count = 0;
  for (const size_t corner : loop.corners) {
    count += length(loop.points[corner]) < 20 ? 1u : 0u;
  }
  return count;
}

TEST(FindCorners, AnArcOfFourUnitsIsNone) {
  Tip tip;
  tip.radius = 4;
  EXPECT_EQ(corners_near_tip(tip), 0u);
}

TEST(FindCorners, ATipThatIsCutHasTwo) {
  Tip tip;
  tip.cut = {2.4, 3.2};  // 4 wide
  EXPECT_EQ(corners_near_tip(tip), 2u);
}

TEST(FindCorners, ASharpTipIsOne) {
  EXPECT_EQ(corners_near_tip(Tip()), 1u);
}

TEST(SegmentCount, CountsTheLineThatCloses) {
  gen::Contour contour;
  for (int i = 0; i < 3; ++i) {
    gen::Segment segment;
    segment.p[0] = kSquare[static_cast<size_t>(i)];
    segment.p[1] = kSquare[static_cast<size_t>(i) + 1];
    contour.segments.push_back(segment);
  }
  EXPECT_EQ(segment_count({{contour}}), 4u);
}

// The width of an upright stroke at a height.
double width_at(const std::vector<Point>& polygon, double y) {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    if ((a.y <= y) != (b.y <= y)) {
      const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
      low = std::min(low, x);
      high = std::max(high, x);
    }
  }
  return high - low;
}

TEST(Stroke, NibsChangeWithoutKinksBetweenKnots) {
  const auto knot = [](double y, double width) {
    StrokePoint point;
    point.at = {0, y};
    point.width = width;
    return point;
  };
  Stroke stroke;
  stroke.nib = {Nib::Kind::rectangle, 40, 1, 0};
  stroke.is_smooth = true;
  stroke.points = {knot(500, 40), knot(250, 40), knot(0, 120)};
  const auto polygons = polygons_of(stroke, 0.5);
  ASSERT_EQ(polygons.size(), 1u);
  const auto width = [&](double y) { return width_at(polygons[0], y); };
  EXPECT_NEAR(width(400), 40, 0.1);
  // A straight change would be 43.2 and 80.
  EXPECT_LT(width(240), 41.5);
  EXPECT_NEAR(width(125), 70, 1);
  EXPECT_NEAR(width(1), 120, 2);
  for (double y = 499; y > 1; --y) {
    ASSERT_LE(width(y), width(y - 1) + 1e-6) << y;
  }
}

TEST(Stroke, EvenChangesStayStraight) {
  Stroke stroke;
  stroke.nib = {Nib::Kind::rectangle, 40, 1, 0};
  stroke.is_smooth = true;
  for (const double y : {300.0, 200.0, 100.0, 0.0}) {
    StrokePoint point;
    point.at = {0, y};
    point.width = 40 + (300 - y) / 5;
    stroke.points.push_back(point);
  }
  const auto polygons = polygons_of(stroke, 0.5);
  ASSERT_EQ(polygons.size(), 1u);
  for (double y = 295; y > 5; y -= 10) {
    EXPECT_NEAR(width_at(polygons[0], y), 40 + (300 - y) / 5, 0.3) << y;
  }
}

}  // namespace
}  // namespace inkcell::design::test
