// Refitted outlines: their distance from the source, and their points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "glyph_outlines.hpp"
#include "outline_reader.hpp"
#include "outlines/expand.hpp"
#include "outlines/refit.hpp"
#include "outlines/unite.hpp"
#include "shape/points.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {
namespace test {
namespace {

RefitOptions options(int units_per_em, int grid_shift, double tolerance_u) {
  RefitOptions result;
  result.units_per_em = units_per_em;
  result.grid_shift = grid_shift;
  result.tolerance_u = tolerance_u;
  return result;
}

// Largest distance of the edges of `a` from the border of `b`.
double stray(const Shape& a, const Shape& b) {
  double most = 0;
  for (const Edge& edge : a.edges()) {
    for (const double t : {0.0, 0.25, 0.5, 0.75}) {
      most = std::max(
          most, std::fabs(b.distance(edge.a.x + t * (edge.b.x - edge.a.x),
                                     edge.a.y + t * (edge.b.y - edge.a.y))));
    }
  }
  return most;
}

double stray(const Outline& source,
             const MinimalOutline& result,
             const RefitOptions& how) {
  const Shape a(source);
  const Shape b(expand(result, how.units_per_em, how.grid_shift));
  return std::max(stray(a, b), stray(b, a));
}

size_t point_count(const MinimalOutline& outline) {
  size_t sum = 0;
  for (const MinimalContour& contour : outline.contours) {
    sum += contour.points.size();
  }
  return sum;
}

double turn_degrees(const GridPoint& a,
                    const GridPoint& b,
                    const GridPoint& c) {
  const double ux = b.x - a.x;
  const double uy = b.y - a.y;
  const double vx = c.x - b.x;
  const double vy = c.y - b.y;
  return std::fabs(std::atan2(ux * vy - uy * vx, ux * vx + uy * vy)) * 180 /
         3.14159265358979;
}

// Invariants that every reader of the outline relies on.
void expect_well_formed(const MinimalOutline& outline) {
  for (const MinimalContour& contour : outline.contours) {
    const std::vector<GridPoint>& points = contour.points;
    const size_t n = points.size();
    ASSERT_GE(n, 2u);
    EXPECT_EQ(points[0].kind, PointKind::corner);
    for (size_t i = 0; i < n; ++i) {
      const GridPoint& before = points[(i + n - 1) % n];
      const GridPoint& after = points[(i + 1) % n];
      EXPECT_FALSE(points[i].x == after.x && points[i].y == after.y);
      if (points[i].kind == PointKind::smooth) {
        EXPECT_LT(turn_degrees(before, points[i], after), 8.01);
      }
    }
  }
}

MinimalOutline refitted(const Outline& outline,
                        const RefitOptions& options,
                        RefitMemo& memo) {
  const Shape shape(outline);
  return minimal_outline(unite(outline, shape), shape, options, memo);
}

MinimalOutline refitted(const Outline& outline, const RefitOptions& options) {
  RefitMemo memo;
  return refitted(outline, options, memo);
}

Outline shape_of(std::vector<Contour> contours) {
  return {std::move(contours)};
}

TEST(Refit, ARectangleIsItsFourCorners) {
  // Points on its edges are removed, the closing edge is not stored.
  const MinimalOutline result = refitted(shape_of({polygon({{10, 20},
                                                            {50, 20},
                                                            {110, 20},
                                                            {110, 80},
                                                            {60, 80},
                                                            {10, 80},
                                                            {10, 40}})}),
                                         options(1024, 0, 0.5));
  ASSERT_EQ(result.contours.size(), 1u);
  EXPECT_EQ(result.contours[0].points.size(), 4u);
  for (const GridPoint& p : result.contours[0].points) {
    EXPECT_TRUE((p.x == 10 || p.x == 110) && (p.y == 20 || p.y == 80));
    EXPECT_EQ(p.kind, PointKind::corner);
  }
}

TEST(Refit, NothingBecomesNothing) {
  EXPECT_TRUE(refitted(shape_of({}), options(1024, 0, 0.5)).contours.empty());
  EXPECT_TRUE(
      refitted(shape_of({polygon({{0, 0}, {9, 9}})}), options(1024, 0, 0.5))
          .contours.empty());
}

// Its control points are off the curve, and the joints midway between them.
TEST(Refit, ACircleOfCubicsBecomesEightQuadratics) {
  const Outline source = shape_of({circle(300, 300, 250)});
  const RefitOptions how = options(2048, 0, 0.5);
  const MinimalOutline result = refitted(source, how);
  ASSERT_EQ(result.contours.size(), 1u);
  EXPECT_LE(result.contours[0].points.size(), 11u);
  EXPECT_LE(stray(source, result, how), 0.5);
  expect_well_formed(result);
  // Its extremes stay where they are.
  const Shape shape(expand(result, 2048, 0));
  EXPECT_NEAR(shape.box().x0, 50, 0.25);
  EXPECT_NEAR(shape.box().x1, 550, 0.25);
  EXPECT_NEAR(shape.box().y0, 50, 0.25);
  EXPECT_NEAR(shape.box().y1, 550, 0.25);
}

TEST(Refit, ADotLessThanTheGridVanishes) {
  const Outline source =
      shape_of({rectangle(0, 0, 100, 100), rectangle(200, 0, 200.1, 0.1)});
  const MinimalOutline result = refitted(source, options(1024, 2, 2));
  EXPECT_EQ(result.contours.size(), 1u);
}

TEST(Refit, HolesKeepTheirDirection) {
  const MinimalOutline result = refitted(
      shape_of({rectangle(0, 0, 300, 300), rectangle(200, 100, 100, 200)}),
      options(1024, 0, 0.5));
  ASSERT_EQ(result.contours.size(), 2u);
  double areas[2] = {};
  for (size_t c = 0; c < 2; ++c) {
    const std::vector<GridPoint>& p = result.contours[c].points;
    for (size_t i = 0; i < p.size(); ++i) {
      const GridPoint& q = p[(i + 1) % p.size()];
      areas[c] += (p[i].x * q.y - p[i].y * q.x) / 2.0;
    }
  }
  EXPECT_EQ(areas[0] + areas[1], 80000);
  EXPECT_LT(areas[0] * areas[1], 0);
}

// The chords of Shape's polygon, as used if a union fails.
TEST(Refit, ChordsBecomeCurvesAgain) {
  const Shape polygon_of(shape_of({circle(300, 300, 250)}));
  Contour chords;
  for (const Edge& edge : polygon_of.edges()) {
    Segment segment;
    segment.p[0] = edge.a;
    segment.p[1] = edge.b;
    chords.segments.push_back(segment);
  }
  const RefitOptions how = options(2048, 0, 0.5);
  const MinimalOutline result = refitted(shape_of({chords}), how);
  EXPECT_LE(point_count(result), 13u);
  EXPECT_LE(stray(shape_of({circle(300, 300, 250)}), result, how), 0.51);
}

struct Face {
  const char* file;
  int index;
  std::vector<uint32_t> code_points;
  RefitOptions how;
  double most_points;  // mean of a glyph
};

std::vector<Face> faces() {
  return {{kDejaVuSans, 0, ascii(), options(2048, 0, 0.5), 16.5},
          {kLiberationSerif, 0, ascii(), options(2048, 0, 0.5), 21.5},
          {kRoboto, 0, ascii(), options(2048, 0, 0.5), 18},
          {kNotoSansCjk,
           2,
           {0x9f8d, 0x6c38, 0x9b31, 0x9177, 0x4e00, 0x56fd},
           options(1000, 1, 2.5),
           100}};
}

TEST(Refit, GlyphsOfFontsStayWithinTheTolerance) {
  for (const Face& face : faces()) {
    const std::vector<Outline> glyphs =
        load_outlines(face.file, face.index, face.code_points);
    double points = 0;
    for (size_t i = 0; i < glyphs.size(); ++i) {
      SCOPED_TRACE(std::string(face.file) + " " +
                   std::to_string(face.code_points[i]));
      const MinimalOutline result = refitted(glyphs[i], face.how);
      expect_well_formed(result);
      EXPECT_LE(stray(glyphs[i], result, face.how),
                face.how.tolerance_u * 1.02);
      points += static_cast<double>(point_count(result));
    }
    EXPECT_LE(points / static_cast<double>(glyphs.size()), face.most_points)
        << face.file;
  }
}

TEST(Refit, TheSameInputGivesTheSamePoints) {
  for (const Face& face : faces()) {
    const Outline glyph =
        load_outlines(face.file, face.index, {face.code_points[0]})[0];
    EXPECT_TRUE(same(refitted(glyph, face.how), refitted(glyph, face.how)));
  }
}

// More rounds with one memo give the same points as without it.
TEST(Refit, AMemoChangesNoPoint) {
  for (const Face& face : faces()) {
    const Outline glyph =
        load_outlines(face.file, face.index, {face.code_points[1]})[0];
    RefitMemo memo;
    RefitOptions how = face.how;
    for (int round = 0; round < 4; ++round) {
      EXPECT_TRUE(same(refitted(glyph, how, memo), refitted(glyph, how)));
      const Segment& somewhere =
          glyph.contours[0].segments[static_cast<size_t>(round)];
      (round % 2 == 0 ? how.careful_u : how.exact_u).push_back(somewhere.p[0]);
    }
    how.tolerance_u *= 0.6;
    EXPECT_TRUE(same(refitted(glyph, how, memo), refitted(glyph, how)));
  }
}

TEST(Fingerprint, TellsWordsAndOrderApart) {
  const auto print = [](std::initializer_list<double> numbers) {
    Fingerprint result;
    for (const double number : numbers) {
      result.add(number);
    }
    return result;
  };
  EXPECT_TRUE(print({1, 2}) == print({1, 2}));
  EXPECT_FALSE(print({1, 2}) == print({2, 1}));
  EXPECT_FALSE(print({1, 2}) == print({1, 2, 0}));
  EXPECT_FALSE(print({0}) == print({}));
}

// A refit of a refit may save a point more, but deviates no farther.
TEST(Refit, ARefitOfARefitTakesNoMorePoints) {
  const RefitOptions how = options(2048, 0, 0.5);
  for (const Outline& glyph :
       load_outlines(kLiberationSerif, 0, {'g', 'R', '&'})) {
    const MinimalOutline once = refitted(glyph, how);
    const Outline again = expand(once, 2048, 0);
    const MinimalOutline twice = refitted(again, how);
    EXPECT_LE(point_count(twice), point_count(once));
    EXPECT_LE(stray(again, twice, how), 0.51);
  }
}

TEST(Refit, CarefulPlacesStrayLessAndHaveCorners) {
  const Outline glyph = load_outlines(kLiberationSerif, 0, {'S'})[0];
  RefitOptions how = options(2048, 0, 2);
  const MinimalOutline plain = refitted(glyph, how);
  const Shape source(glyph);
  for (const Edge& edge : source.edges()) {
    how.careful_u.push_back(edge.a);
  }
  const MinimalOutline careful = refitted(glyph, how);
  EXPECT_GT(stray(glyph, plain, how), 1);
  EXPECT_LE(stray(glyph, careful, how), 0.51);
  EXPECT_GT(point_count(careful), point_count(plain));
  const auto no_curve_goes_on = [](const MinimalOutline& outline) {
    for (const MinimalContour& contour : outline.contours) {
      for (size_t i = 0; i < contour.points.size(); ++i) {
        const PointKind kind = contour.points[i].kind;
        const PointKind next =
            contour.points[(i + 1) % contour.points.size()].kind;
        if (kind == PointKind::smooth ||
            (kind == PointKind::off_curve && next == PointKind::off_curve)) {
          return false;
        }
      }
    }
    return true;
  };
  EXPECT_TRUE(no_curve_goes_on(careful));
  // All points of the source, and the middles of its curves.
  how.exact_u.swap(how.careful_u);
  const MinimalOutline exact = refitted(glyph, how);
  EXPECT_TRUE(no_curve_goes_on(exact));
  EXPECT_GT(point_count(exact), point_count(careful));
  EXPECT_LE(stray(glyph, exact, how), 0.51);
}

// Chords of a curve, each too short to be recognised as a part of it.
TEST(Refit, ShortChordsStayWhereTheSourceIsKept) {
  std::vector<Point> corners;
  for (int i = 0; i < 60; ++i) {
    const double angle = i * kPi / 30;
    corners.push_back({500 + 50 * std::cos(angle), 500 + 50 * std::sin(angle)});
  }
  const Outline source = shape_of({polygon(corners)});
  RefitOptions how = options(2048, 0, 0.5);
  EXPECT_LT(point_count(refitted(source, how)), 30u);
  how.exact_u = corners;
  EXPECT_EQ(point_count(refitted(source, how)), 60u);
}

TEST(Refit, CareIsLocal) {
  const Outline glyph = load_outlines(kLiberationSerif, 0, {'S'})[0];
  RefitOptions how = options(2048, 0, 0.5);
  const size_t plain = point_count(refitted(glyph, how));
  how.careful_u.push_back(Shape(glyph).edges()[0].a);
  const size_t careful = point_count(refitted(glyph, how));
  EXPECT_LE(careful, plain + 10);
  how.careful_u = {{5000, 5000}};
  EXPECT_EQ(point_count(refitted(glyph, how)), plain);
}

}  // namespace
}  // namespace test
}  // namespace inkcell::gen
