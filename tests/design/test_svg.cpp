// SVG: path data, transforms, what is filled; outlines as glyphs.
#include <gtest/gtest.h>

#include <cmath>

#include "export/svg.hpp"
#include "folders.hpp"
#include "import/outline_commands.hpp"
#include "import/svg_import.hpp"
#include "import/svg_path.hpp"
#include "model/commands.hpp"
#include "model/contours.hpp"
#include "model/error.hpp"
#include "shape/shape.hpp"
#include "trace/field_outline.hpp"

namespace inkcell::design::test {
namespace {

gen::Shape shape_of(const std::string& elements) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "drawing.svg";
  write_text(file,
             "<svg xmlns='http://www.w3.org/2000/svg'>" + elements + "</svg>");
  return gen::Shape(read_svg(file, DrawingPlace()));
}

std::string refusal(const std::string& elements) {
  try {
    shape_of(elements);
  } catch (const Error& error) {
    const std::string text = error.what();
    return text.substr(text.find("drawing.svg") + 11);
  }
  return "";
}

std::string path_refusal(const char* data) {
  try {
    parse_svg_path(data);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// The same square in all ways that the letters allow.
TEST(SvgPath, LettersMeanWhatTheStandardSays) {
  for (const char* data :
       {"M0 0L100 0L100 100L0 100Z", "m0,0 100,0 0,100-100,0z",
        "M0 0H100V100H0V0", "M1e2 0 0 0v100h+100z",
        "M0 0C10 0 90 0 100 0S100 90 100 100T50 100 0 100Q0 50 0 0"}) {
    const gen::Shape shape(parse_svg_path(data));
    for (int i = 0; i < 400; ++i) {
      const double x = i % 20 * 10 - 45;
      const double y = i / 20 * 10 - 45;
      const bool inside = x > 0 && x < 100 && y > 0 && y < 100;
      EXPECT_EQ(shape.inside(x, y), inside) << data << " " << x << " " << y;
    }
  }
}

TEST(SvgPath, ArcsAreRoundToATwoHundredThousandth) {
  // Half a circle each: small and large, both ways; and an ellipse turned by
  // 90 degrees whose radii are too small and grow.
  const gen::Shape disc(
      parse_svg_path("M-300 0A300 300 0 0 1 300 0A300 300 0 1 1-300 0"));
  const gen::Shape grown(
      parse_svg_path("M0-300A1 2 90 000 300A1 2 90 000-300"));
  for (int i = 0; i < 360; ++i) {
    const double c = std::cos(i * 0.0174533);
    const double s = std::sin(i * 0.0174533);
    // The shape's own chords are within 1/64 u.
    EXPECT_NEAR(disc.distance(300 * c, 300 * s), 0, 1.0 / 50) << i;
    EXPECT_NEAR(grown.distance(600 * c, 300 * s), 0, 1.0 / 50) << i;
  }
  const gen::Shape quarter(parse_svg_path("M0 0V-200A200 200 0 0 1 200 0Z"));
  EXPECT_TRUE(quarter.inside(140, -140));
  EXPECT_FALSE(quarter.inside(143, -143));
  const gen::Shape rest(parse_svg_path("M0 0V-200A200 200 0 1 0 200 0Z"));
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
  EXPECT_NE(path_refusal("M1 2L1e999 0"), "");
  EXPECT_NE(path_refusal("M1"), "");
}

TEST(Svg, TransformsAreCarriedOutFromTheOutermostOn) {
  const gen::Shape shape = shape_of(
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
    const gen::Shape shape = shape_of(ring);
    EXPECT_TRUE(shape.inside(10, -10)) << ring;
    EXPECT_FALSE(shape.inside(45, -45)) << ring;
  }
}

TEST(Svg, ErrorsNameTheElement) {
  EXPECT_EQ(refusal("<g><rect width='5' height='5'/></g>"),
            ": <rect> is no path; convert it to one");
  EXPECT_EQ(refusal("<path fill='none' d='M0 0H9V9Z'/>"),
            ": holds no filled path");
  EXPECT_EQ(refusal("<defs><path d='M0 0H9V9Z'/></defs>"),
            ": holds no filled path");
  EXPECT_EQ(refusal("<path transform='turn(3)' d='M0 0H9V9Z'/>"),
            ": transform 'turn(3)' is not one of SVG 1.1");
}

// A glyph, written as SVG and read again, is the same glyph.
TEST(Svg, WhatIsWrittenIsRead) {
  Project project;
  project.apply(change_of(project, {{"do", "add_glyph"}, {"glyph", "a"}}));
  project.apply(change_of(project, Value::parse(R"({"do": "set_strokes",
      "glyph": "a", "strokes": [{"nib": "ellipse:120,40,30", "points":
      [[100,0],[300,600],[500,100],[200,300]]}]})")));
  const gen::Outline before = outline_of(project, *project.glyph("a"));
  const TemporaryFolder folder;
  write_text(folder.path() / "a.svg", svg_document(before, "a"));
  const gen::Outline read = read_svg(folder.path() / "a.svg", DrawingPlace());
  for (const Value& command : commands_for_outline(project, "b", read)) {
    project.apply(change_of(project, command));
  }
  const GlyphPointer glyph = project.glyph("b");
  EXPECT_GT(glyph->width, 400);
  EXPECT_EQ(glyph->contours.size(), before.contours.size());
  const EdgeError error = edge_error(
      gen::Shape(before), gen::Shape(outline_of(project, *glyph)), 1);
  EXPECT_LT(error.worst, 0.02);
  EXPECT_GT(error.length_u, 1000);
}

}  // namespace
}  // namespace inkcell::design::test
