// SVG: path data, shapes, transforms, strokes, fills, errors.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "messages.hpp"
#include "sfnt_builder.hpp"
#include "shape/flatten.hpp"
#include "shape/points.hpp"
#include "shape/shape.hpp"
#include "svg/path_data.hpp"
#include "svg/region.hpp"
#include "svg/svg_drawing.hpp"

namespace inkcell::gen::test {
namespace {

SvgDrawing drawing_of(const std::string& elements) {
  const TestFolder folder;
  const std::string text =
      "<svg xmlns='http://www.w3.org/2000/svg'>" + elements + "</svg>";
  return SvgDrawing(folder.write("drawing.svg", text));
}

constexpr Affine kUp = {1, 0, 0, -1, 0, 0};

// The outline of elements, in user units, y up.
Outline outline_of(const std::string& elements) {
  return drawing_of(elements).outline(kUp);
}

Shape shape_of(const std::string& elements) {
  return Shape(outline_of(elements));
}

std::string path_refusal(const char* data) {
  return error_of([&] { parse_path_data(data); });
}

// The same square by all letters.
TEST(SvgPath, LettersMeanWhatTheStandardSays) {
  for (const char* data :
       {"M0 0L100 0L100 100L0 100Z", "m0,0 100,0 0,100-100,0z",
        "M0 0H100V100H0V0", "M1e2 0 0 0v100h+100z",
        "M0 0C10 0 90 0 100 0S100 90 100 100T50 100 0 100Q0 50 0 0"}) {
    const Shape shape(contours_of(parse_path_data(data)));
    for (int i = 0; i < 400; ++i) {
      const double x = i % 20 * 10 - 45;
      const double y = i / 20 * 10 - 45;
      const bool inside = x > 0 && x < 100 && y > 0 && y < 100;
      EXPECT_EQ(shape.inside(x, y), inside) << data << " " << x << " " << y;
    }
  }
}

TEST(SvgPath, ArcsAreRoundToATwoHundredThousandth) {
  // Half a circle each: small and large, in both directions; and an ellipse
  // turned by 90 degrees whose radii are too small and grow.
  const Shape disc(contours_of(
      parse_path_data("M-300 0A300 300 0 0 1 300 0A300 300 0 1 1-300 0")));
  const Shape grown(
      contours_of(parse_path_data("M0-300A1 2 90 000 300A1 2 90 000-300")));
  for (int i = 0; i < 360; ++i) {
    const double c = std::cos(i * 0.0174533);
    const double s = std::sin(i * 0.0174533);
    // The shape's own chords are within 1/64 u.
    EXPECT_NEAR(disc.distance(300 * c, 300 * s), 0, 1.0 / 50) << i;
    EXPECT_NEAR(grown.distance(600 * c, 300 * s), 0, 1.0 / 50) << i;
  }
  const Shape quarter(
      contours_of(parse_path_data("M0 0V-200A200 200 0 0 1 200 0Z")));
  EXPECT_TRUE(quarter.inside(140, -140));
  EXPECT_FALSE(quarter.inside(143, -143));
  const Shape rest(
      contours_of(parse_path_data("M0 0V-200A200 200 0 1 0 200 0Z")));
  EXPECT_FALSE(rest.inside(100, -100));
  EXPECT_TRUE(rest.inside(-100, 100));
}

TEST(SvgPath, ErrorsSayWhere) {
  EXPECT_EQ(path_refusal("L1 2"),
            "path data, character 1: 'L1 2' is not M, with which a path "
            "begins");
  EXPECT_EQ(path_refusal("M1 2 3 x"),
            "path data, character 8: 'x' is not a number");
  EXPECT_EQ(path_refusal("M1 2B3"),
            "path data, character 5: 'B3' is not a command of SVG: M, L, H, V, "
            "C, S, Q, T, A or Z");
  EXPECT_EQ(path_refusal("M1 2A1 1 0 2 0 3 3"),
            "path data, character 12: '2 0 3 3' is not 0 or 1");
  EXPECT_NE(path_refusal("M1 2L1e999 0"), "no error");
  EXPECT_NE(path_refusal("M1"), "no error");
}

TEST(Svg, TransformsAreCarriedOutFromTheOutermostOn) {
  const Shape shape = shape_of(
      "<g transform='translate(100 50) scale(2)'>"
      "<path transform='rotate(90)' d='M0 0H50V-10H0Z'/></g>");
  // The bar hangs from (100, -50) in u, 100 long and 20 wide.
  EXPECT_TRUE(shape.inside(110, -60));
  EXPECT_TRUE(shape.inside(119, -149));
  EXPECT_FALSE(shape.inside(110, -151));
  EXPECT_FALSE(shape.inside(99, -60));
}

TEST(Svg, HolesStayHolesByBothRules) {
  const std::string rings[] = {
      "<path d='M0 0H90V90H0Z M30 30V60H60V30Z'/>",
      "<path d='M0 0V90H90V0Z M30 30H60V60H30Z'/>",
      "<path fill-rule='evenodd' d='M0 0H90V90H0Z M30 30H60V60H30Z'/>",
      "<g style='fill-rule: evenodd'>"
      "<path d='M0 0V90H90V0Z M30 30V60H60V30Z'/></g>"};
  for (const std::string& ring : rings) {
    const Shape shape = shape_of(ring);
    EXPECT_TRUE(shape.inside(10, -10)) << ring;
    EXPECT_FALSE(shape.inside(45, -45)) << ring;
  }
}

// Areas of elements that are drawn exactly, or as curves.
double area_of(const std::string& elements) {
  double sum = 0;
  const Shape shape = shape_of(elements);
  for (const Edge& edge : shape.edges()) {
    sum += (edge.a.x * edge.b.y - edge.a.y * edge.b.x) / 2;
  }
  return sum;
}

// The change of a polygon's area by rounding to 1/65536 u. [u^2]
constexpr double kRounding = 0.01;

// The area that chords cut off inside an ellipse, or a part of it. A chord of a
// curve b(t), with steps of h, is off by at most |b''| t (h - t) / 2, on
// average 2/3 of the maximum, which is the bound. The ellipse is no longer than
// 2 pi sqrt((rx^2 + ry^2) / 2); its cubics are off by 1/200000 of the radius.
double chord_loss(double rx, double ry, double bound = kFlatteningBound) {
  const double around = 2 * M_PI * std::sqrt((rx * rx + ry * ry) / 2);
  return around * (bound * 2 / 3 + std::max(rx, ry) / 200000) + kRounding;
}

TEST(Svg, BasicShapesHaveTheirArea) {
  EXPECT_NEAR(area_of("<rect x='1' y='2' width='30' height='20'/>"), 600,
              kRounding);
  EXPECT_NEAR(area_of("<rect width='30' height='20' rx='5'/>"),
              600 - (4 - M_PI) * 25, chord_loss(5, 5));
  EXPECT_NEAR(area_of("<rect width='30' height='20' rx='99'/>"), M_PI * 15 * 10,
              chord_loss(15, 10));
  EXPECT_NEAR(area_of("<circle cx='9' cy='9' r='20'/>"), M_PI * 400,
              chord_loss(20, 20));
  EXPECT_NEAR(area_of("<ellipse rx='20' ry='10'/>"), M_PI * 200,
              chord_loss(20, 10));
  EXPECT_NEAR(area_of("<polygon points='0,0 10,0 10 10'/>"), 50, kRounding);
  EXPECT_NEAR(area_of("<polyline points='0,0 10,0 10 10'/>"), 50, kRounding);
}

std::string stroke(const std::string& more, const std::string& data) {
  return "<path fill='none' stroke='black' stroke-width='10' " + more + " d='" +
         data + "'/>";
}

TEST(Svg, StrokesHaveTheirArea) {
  const double corner = 10 * 10;
  const double round = chord_loss(5, 5);
  EXPECT_NEAR(area_of(stroke("", "M0 0H50")), 500, kRounding);
  EXPECT_NEAR(area_of(stroke("stroke-linecap='square'", "M0 0H50")), 600,
              kRounding);
  EXPECT_NEAR(area_of(stroke("stroke-linecap='round'", "M0 0H50")),
              500 + M_PI * 25, round);
  EXPECT_NEAR(area_of(stroke("", "M0 0H50V50")), 1000, kRounding);
  EXPECT_NEAR(area_of(stroke("stroke-linejoin='bevel'", "M0 0H50V50")),
              1000 - corner / 8, kRounding);
  EXPECT_NEAR(area_of(stroke("stroke-linejoin='round'", "M0 0H50V50")),
              1000 - corner / 4 + M_PI * corner / 16, round);
  // A right angle has a miter of 1.41 widths.
  EXPECT_NEAR(area_of(stroke("stroke-miterlimit='1.4'", "M0 0H50V50")),
              1000 - corner / 8, kRounding);
  EXPECT_NEAR(area_of(stroke("stroke-miterlimit='1.5'", "M0 0H50V50")), 1000,
              kRounding);
  EXPECT_NEAR(area_of(stroke("", "M0 0H50V50H0Z")), 60 * 60 - 40 * 40,
              kRounding);
  EXPECT_NEAR(area_of(stroke("stroke-linecap='round'", "M5 5z")), M_PI * 25,
              round);
  EXPECT_NEAR(area_of(stroke("stroke-linecap='square'", "M5 5h0")), 100,
              kRounding);
}

// The border of a stroke along a curve is a curve, within the bound of the
// stroke and that of the shape's own chords.
TEST(Svg, StrokesOfCurvesHaveBordersAtHalfThePen) {
  const Point p[] = {{0, 0}, {40, 100}, {110, 90}, {120, 0}};
  const std::string data = "M0 0C40 100 110 90 120 0";
  const Shape cubic = shape_of(stroke("", data));
  // The same path with a handle of no length at its start.
  const Shape bare = shape_of(stroke("", "M0 0C0 0 110 90 120 0"));
  const double bound = kStrokeBound_u + kFlatteningBound;
  for (int i = 1; i < 100; ++i) {
    const double t = i / 100.0;
    for (const bool is_bare : {false, true}) {
      Segment curve{Segment::Kind::cubic, {p[0], p[1], p[2], p[3]}};
      curve.p[1] = is_bare ? p[0] : p[1];
      const Point ahead = point_on(curve, t + 1e-5);
      const Point along = direction(ahead - point_on(curve, t - 1e-5));
      const Point at = point_on(curve, t) + 5.0 * Point{-along.y, along.x};
      const Shape& shape = is_bare ? bare : cubic;
      EXPECT_NEAR(shape.distance(at.x, -at.y), 0, bound) << t << is_bare;
    }
  }
}

TEST(Svg, CurvesOfStrokesStayCurves) {
  const auto counts = [](const std::string& path) {
    const Outline outline = outline_of(path);
    size_t lines = 0;
    size_t curves = 0;
    for (const Contour& contour : outline.contours) {
      for (const Segment& segment : contour.segments) {
        ++(segment.kind == Segment::Kind::line ? lines : curves);
      }
    }
    return std::make_pair(lines, curves);
  };
  const auto [lines, curves] =
      counts(stroke("stroke-linejoin='round'", "M0 0H50V50Q90 50 90 0"));
  EXPECT_LE(lines, 12u);
  EXPECT_LE(curves, 16u);
  EXPECT_GE(curves, 6u);
  // Also with a handle of no length.
  EXPECT_GE(counts(stroke("", "M0 0C0 0 110 90 120 0")).second, 2u);
  // Where the path turns more tightly than half the pen, chords are used.
  EXPECT_EQ(counts(stroke("", "M0 0A3 3 0 0 1 6 0")).second, 0u);
}

TEST(Svg, SmallHolesAndIslandsAreKept) {
  // Squares of 0.2 u: a hole, and an island in a larger one. Contours cross, so
  // everything becomes chords.
  EXPECT_NEAR(area_of("<path fill-rule='evenodd' d='M0 0H20V20H0Z "
                      "M10 10H30V30H10Z M5 5h.2v.2h-.2z M12 12h.2v.2h-.2z'/>"),
              600 - 0.04 + 0.04, 0.001);
  const auto holes = [](double w, double h) {
    const double r = 10 + w;
    const double t = 10 + h;
    return united_area({{{0, 0}, {0, t + 10}, {10, t + 10}, {10, 0}},
                        {{r, 0}, {r, t + 10}, {r + 10, t + 10}, {r + 10, 0}},
                        {{5, 0}, {r + 5, 0}, {r + 5, 10}, {5, 10}},
                        {{5, t}, {r + 5, t}, {r + 5, t + 10}, {5, t + 10}}})
               .contours.size() -
           1;
  };
  EXPECT_EQ(holes(0.2, 0.2), 1u);
  EXPECT_EQ(holes(100, 0.001), 1u);
  // Residues of rounding: 1/65536 u wide.
  EXPECT_EQ(holes(100, 1.0 / 65536), 0u);
}

// A circle that is tighter than the pen has no hole.
// Chords replace the circle (radius 3) and the pen's border (radius 5), and the
// stroke is the sum of the two polygons: of the area that chords with angles a
// and b take, 2/3 of the bound along 2 pi (3 + 5) is that of each polygon, and
// 2 pi 15 (a^2 + b^2) / 24, a^2 <= 8/3 bound, b^2 <= 8/5 bound, that of both.
TEST(Svg, TightStrokesAreFull) {
  EXPECT_NEAR(area_of("<circle r='3' fill='none' stroke='black' "
                      "stroke-width='10'/>"),
              M_PI * 64, 2 * M_PI * 8 * kStrokeBound_u + kRounding);
}

TEST(Svg, PensAreTransformedToo) {
  EXPECT_NEAR(area_of("<path transform='scale(2 5)' fill='none' stroke='black' "
                      "stroke-width='4' d='M0 0H50'/>"),
              100 * 20, 0.01);
  EXPECT_NEAR(area_of("<g stroke='#000' stroke-width='4'><path "
                      "transform='scale(-1 1)' d='M0 0V50'/></g>"),
              200, 0.01);
}

TEST(Svg, BothRulesHoldWhereContoursCross) {
  const std::string two = "d='M0 0H20V20H0Z M10 10H30V30H10Z'/>";
  EXPECT_NEAR(area_of("<path " + two), 700, 0.01);
  EXPECT_NEAR(area_of("<path fill-rule='evenodd' " + two), 600, 0.01);
  // Opposite directions, separate and with a third one over both.
  EXPECT_NEAR(area_of("<path d='M0 0H20V20H0Z M40 0V20H60V0Z'/>"
                      "<rect x='10' width='40' height='20'/>"),
              60 * 20, 0.01);
}

TEST(Svg, WhatIsNotSeenIsNotDrawn) {
  EXPECT_NEAR(area_of("<rect width='9' height='9' fill='none'/>"
                      "<g opacity='0'><rect width='90' height='9'/></g>"
                      "<g display='none'><text>no</text></g>"
                      "<g visibility='hidden'><rect width='9' height='9'/></g>"
                      "<rect width='2' height='5' fill='currentColor'/>"
                      "<path stroke='none' d='M0 0'/><title>no</title>"
                      "<path style='text-transform:none;marker:none' d=''/>"),
              10, 0.01);
}

TEST(Svg, RefusalsNameLineElementAndRemedy) {
  const struct {
    const char* elements;
    const char* text;
  } cases[] = {
      {"<g>\n<text>A</text></g>",
       "line 2: <text> is not supported; convert the text to paths"},
      {"<image/>", "line 1: <image> is not supported; trace the picture"},
      {"<use href='#a'/>", "<use> is not supported; replace it by a copy"},
      {"<style>.a{fill:red}</style>", "without style sheets"},
      {"<defs><style>.a{fill:red}</style></defs>", "without style sheets"},
      {"<svg:path d='M0 0h9v9z'/>", "as plain SVG, without prefixes"},
      {"<path fill='#0008' d='M0 0h9v9z'/>", "fill='#0008' has an alpha"},
      {"<svg/>", "move what it holds into the outer one"},
      {"<foreignObject/>", "convert it to paths, or remove it"},
      {"<path fill='url(#g)' d='M0 0h9v9z'/>",
       "<path> fill='url(#g)' is a gradient or a pattern"},
      {"<path fill='red' d='M0 0h9v9z'/>\n<path d='M0 0h9v9z'/>",
       "line 2: <path> is painted in #000000, what comes before it in red"},
      {"<path stroke='blue' d='M0 0h9v9z'/>", "is painted in blue"},
      {"<path opacity='.5' d='M0 0h9v9z'/>", "opacity='.5' is part transp"},
      {"<g clip-path='url(#c)'/>", "<g> clip-path='url(#c)' is not supported"},
      {"<g mask='url(#c)'/>", "cut the paths themselves"},
      {"<g filter='url(#c)'/>", "<g> filter='url(#c)' is not supported"},
      {"<path marker-end='url(#c)' d=''/>", "draw the marker as a path"},
      {"<path stroke-dasharray='2 1' d=''/>", "draw each dash as a path"},
      {"<path style='transform: none' d=''/>", "use the attribute transform"},
      {"<path style='rotate: 45deg' d=''/>", "use the attribute transform"},
      {"<circle r='3' style='cx: 4'/>",
       "<circle> style has cx, which is not supported; write it as an attr"},
      {"<g style='mask-image: url(#c)'/>", "cut the paths themselves"},
      {"<g style='backdrop-filter: blur(2px)'/>", "is not supported; remove"},
      {"<rect width='50%' height='9'/>", "width='50%' is no number of user"},
      {"<rect width='-5' height='9'/>", "width='-5' is below 0"},
      {"<polygon points='1 2 3'/>", "points has an odd number"},
      {"<path stroke-linejoin='arcs' d=''/>", "use one of miter, round, bevel"},
      {"<path transform='turn(3)' d=''/>",
       "transform 'turn(3)' is not one of SVG 1.1"},
      {"<path d='M0 0h9x'/>", "<path> path data, character 7: 'x' is not"},
      {"<path d='M0 0h1e9v9z'/>", "is not within 14912/1024 em"},
      {"<defs><path d='M0 0H9V9Z'/></defs>",
       "draws nothing; fill or stroke a path of it"}};
  for (const auto& wrong : cases) {
    EXPECT_TRUE(
        contains(error_of([&] { shape_of(wrong.elements); }), wrong.text))
        << wrong.elements;
  }
}

// They change nothing where there is one colour.
TEST(Svg, BlendingIsRefusedWhereThereAreColours) {
  const struct {
    const char* elements;
    const char* text;
  } cases[] = {
      {"<path style='mix-blend-mode:multiply' d='M0 0h9v9z'/>",
       "line 1: <path> mix-blend-mode='multiply' is not supported; paint with"},
      {"<path paint-order='stroke' d='M0 0h9v9z'/>",
       "<path> paint-order='stroke' is not supported; draw the stroke as an"}};
  for (const auto& wrong : cases) {
    EXPECT_TRUE(contains(
        error_of([&] { drawing_of(wrong.elements).layers(kUp); }), wrong.text))
        << wrong.elements;
    EXPECT_FALSE(outline_of(wrong.elements).contours.empty());
  }
  EXPECT_EQ(drawing_of("<path style='mix-blend-mode:normal' d='M0 0h9v9z'/>")
                .layers(kUp)
                .size(),
            1u);
}

}  // namespace
}  // namespace inkcell::gen::test
