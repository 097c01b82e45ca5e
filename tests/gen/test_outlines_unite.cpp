// Unions of contours: their rings, their area, and that curves stay curves.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "glyph_outlines.hpp"
#include "outlines/curves.hpp"
#include "outlines/unite.hpp"
#include "shape/flatten.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {
namespace test {
namespace {

double area(const Contour& contour) {
  double twice = 0;
  for (const Segment& segment : contour.segments) {
    twice += twice_area(segment);
  }
  return twice / 2;
}

double area(const Outline& o) {
  double sum = 0;
  for (const Contour& contour : o.contours) {
    sum += area(contour);
  }
  return sum;
}

double area(const Shape& shape) {
  double twice = 0;
  for (const Edge& edge : shape.edges()) {
    twice += edge.a.x * edge.b.y - edge.a.y * edge.b.x;
  }
  return twice / 2;
}

size_t segment_count(const Outline& o) {
  size_t sum = 0;
  for (const Contour& contour : o.contours) {
    sum += contour.segments.size();
  }
  return sum;
}

void expect_closed(const Outline& o) {
  for (const Contour& contour : o.contours) {
    Point pen = end_of(contour.segments.back());
    for (const Segment& segment : contour.segments) {
      EXPECT_EQ(segment.p[0].x, pen.x);
      EXPECT_EQ(segment.p[0].y, pen.y);
      pen = end_of(segment);
    }
  }
}

// The signed area of the contours is that of the union, so nothing overlaps and
// all directions are right; and all contours are on its border.
void expect_union(const Outline& source) {
  const Outline united = unite(source);
  const Shape shape(source);
  expect_closed(united);
  double border = 1;
  for (const Edge& edge : shape.edges()) {
    border += std::hypot(edge.b.x - edge.a.x, edge.b.y - edge.a.y);
  }
  EXPECT_NEAR(area(united), area(shape), border * 2 * kFlatteningBound);
  for (const Contour& contour : united.contours) {
    for (const Segment& segment : contour.segments) {
      for (const double t : {0.0, 0.25, 0.5, 0.75}) {
        const Point p = point_on(segment, t);
        ASSERT_NEAR(shape.distance(p.x, p.y), 0, 2 * kFlatteningBound)
            << p.x << ", " << p.y;
      }
    }
  }
}

TEST(Unite, CrossingSquaresMakeOneContour) {
  const Outline source =
      outline({rectangle(0, 0, 200, 200), rectangle(100, 100, 300, 300)});
  const Outline united = unite(source);
  ASSERT_EQ(united.contours.size(), 1u);
  EXPECT_EQ(united.contours[0].segments.size(), 8u);
  EXPECT_DOUBLE_EQ(area(united), 70000);
  expect_union(source);
}

TEST(Unite, OuterContoursRunCounterClockwiseAndHolesClockwise) {
  // Both clockwise in the source, the hole counter-clockwise.
  const Outline united = unite(
      outline({rectangle(300, 0, 0, 300), rectangle(100, 100, 200, 200)}));
  ASSERT_EQ(united.contours.size(), 2u);
  EXPECT_DOUBLE_EQ(area(united.contours[0]), 90000);
  EXPECT_DOUBLE_EQ(area(united.contours[1]), -10000);
}

TEST(Unite, ContoursInsideAFilledAreaAreDropped) {
  const Outline united = unite(
      outline({rectangle(0, 0, 300, 300), rectangle(100, 100, 200, 200)}));
  ASSERT_EQ(united.contours.size(), 1u);
  EXPECT_DOUBLE_EQ(area(united), 90000);
}

TEST(Unite, FigureOfEightFallsInTwo) {
  const Outline source =
      outline({polygon({{0, 0}, {200, 200}, {200, 0}, {0, 200}})});
  const Outline united = unite(source);
  ASSERT_EQ(united.contours.size(), 2u);
  EXPECT_NEAR(area(united.contours[0]), 10000, 1e-6);
  EXPECT_NEAR(area(united.contours[1]), 10000, 1e-6);
  expect_union(source);
}

TEST(Unite, PentagramIsItsOutline) {
  std::vector<Point> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 0.3 + i * 4 * 3.14159265358979 / 5;
    star.push_back({250 * std::cos(angle), 250 * std::sin(angle)});
  }
  const Outline united = unite(outline({polygon(star)}));
  ASSERT_EQ(united.contours.size(), 1u);
  EXPECT_EQ(united.contours[0].segments.size(), 10u);
  expect_union(outline({polygon(star)}));
}

TEST(Unite, TouchingContoursStayApart) {
  const Outline corners = unite(
      outline({rectangle(0, 0, 100, 100), rectangle(100, 100, 200, 200)}));
  ASSERT_EQ(corners.contours.size(), 2u);
  EXPECT_EQ(corners.contours[0].segments.size(), 4u);
  EXPECT_EQ(corners.contours[1].segments.size(), 4u);
  // A common edge vanishes.
  const Outline edges =
      unite(outline({rectangle(0, 0, 100, 200), rectangle(100, 0, 300, 200)}));
  ASSERT_EQ(edges.contours.size(), 1u);
  EXPECT_DOUBLE_EQ(area(edges), 60000);
}

TEST(Unite, TheSameContourTwiceIsOne) {
  const Outline squares =
      unite(outline({rectangle(0, 0, 99, 99), rectangle(0, 0, 99, 99)}));
  ASSERT_EQ(squares.contours.size(), 1u);
  EXPECT_EQ(squares.contours[0].segments.size(), 4u);
  const Outline circles = unite(outline({circle(0, 0, 99), circle(0, 0, 99)}));
  ASSERT_EQ(circles.contours.size(), 1u);
  EXPECT_EQ(circles.contours[0].segments.size(), 4u);
}

TEST(Unite, CurvesStayCurves) {
  const Outline source = outline({circle(0, 0, 100), circle(120, 10, 90)});
  const Outline united = unite(source);
  ASSERT_EQ(united.contours.size(), 1u);
  EXPECT_LE(united.contours[0].segments.size(), 8u);
  for (const Segment& segment : united.contours[0].segments) {
    EXPECT_EQ(segment.kind, Segment::Kind::cubic);
  }
  expect_union(source);
}

TEST(Unite, AContourWithoutOverlapIsUnchanged) {
  const Outline source = outline({circle(40, 30, 100)});
  const Outline united = unite(source);
  ASSERT_EQ(united.contours.size(), 1u);
  ASSERT_EQ(united.contours[0].segments.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      const Point& a = source.contours[0].segments[i].p[k];
      const Point& b = united.contours[0].segments[i].p[k];
      EXPECT_EQ(a.x, b.x);
      EXPECT_EQ(a.y, b.y);
    }
  }
}

TEST(Unite, DegenerateContoursAreDropped) {
  for (const Outline& nothing :
       {outline({}), outline({Contour()}), outline({polygon({{5, 5}})}),
        outline({polygon({{0, 0}, {100, 0}})}),
        outline({polygon({{0, 0}, {100, 100}, {50, 50}})})}) {
    EXPECT_TRUE(unite(nothing).contours.empty());
  }
  EXPECT_EQ(
      unite(outline({rectangle(0, 0, 100, 100), Contour(), polygon({{50, 50}}),
                     polygon({{-50, 50}, {150, 50}})}))
          .contours.size(),
      1u);
}

TEST(Unite, RefusesCoordinatesThatAreNone) {
  EXPECT_THROW(unite(outline({rectangle(0, 0, 1e12, 10)})), GeometryError);
}

// The two curves coincide for a part of their length.
TEST(Unite, CurvesThatRunAlongEachOtherStayCurves) {
  Contour a = circle(0, 0, 100);
  Contour b = circle(0, 0, 100);
  b.segments[0] = part_of(b.segments[0], 0, 0.5);
  b.segments.resize(1);
  expect_union(outline({a, b}));
  EXPECT_EQ(segment_count(unite(outline({a, b}))), 4u);
}

// A curve that returns along itself, nearer than the precision of crossings.
TEST(Unite, CurvesBesideAHairlineStayCurves) {
  for (const double width : {1e-2, 1e-3, 1e-4, 1e-5}) {
    SCOPED_TRACE(width);
    Contour drop = circle(0, 0, 100);
    const Point a = end_of(drop.segments[0]);
    Segment out;
    out.p[0] = a;
    out.p[1] = {a.x + 7, a.y + 90};
    Segment back = out;
    back.p[0] = out.p[1];
    back.p[1] = {a.x - width, a.y};
    drop.segments.insert(drop.segments.begin() + 1, {out, back});
    drop.segments[3].p[0] = back.p[1];
    expect_union(outline({drop}));
    EXPECT_LE(segment_count(unite(outline({drop}))), 6u);
  }
}

// The residue of a counter that a variable font turned inside out.
TEST(Unite, SliversAreDropped) {
  const Contour square = rectangle(0, 0, 300, 300);
  const auto count = [&](double width, double height) {
    return unite(outline(
                     {square, rectangle(100 + width, 100, 100, 100 + height)}))
        .contours.size();
  };
  EXPECT_EQ(count(0.06, 12), 1u);
  EXPECT_EQ(count(12, 0.06), 1u);
  // Long or wide ones are kept: thin strokes, and dots.
  EXPECT_EQ(count(0.06, 120), 2u);
  EXPECT_EQ(count(0.3, 1), 2u);
}

TEST(Unite, GlyphsOfFonts) {
  struct Glyphs {
    const char* file;
    int index;
    std::vector<uint32_t> code_points;
  };
  const std::vector<Glyphs> faces = {
      {kDejaVuSans, 0, ascii()},
      {kLiberationSerif, 0, ascii()},
      {kRoboto, 0, ascii()},
      // Letters of more than one overlapping part.
      {kDejaVuSans, 0, {0xc5, 0xc7, 0x1fe}},
      {kNotoSansCjk, 2, {0x9f8d, 0x6c38, 0x9b31}}};
  for (const Glyphs& face : faces) {
    const std::vector<Outline> glyphs =
        load_outlines(face.file, face.index, face.code_points);
    for (size_t i = 0; i < glyphs.size(); ++i) {
      SCOPED_TRACE(std::string(face.file) + " " +
                   std::to_string(face.code_points[i]));
      expect_union(glyphs[i]);
      const Outline once = unite(glyphs[i]);
      // Curves are not split, and there is nothing left to unite.
      EXPECT_LE(segment_count(once), segment_count(glyphs[i]) + 8);
      EXPECT_EQ(segment_count(unite(once)), segment_count(once));
    }
  }
}

}  // namespace
}  // namespace test
}  // namespace inkcell::gen
