// SVG as read and written by the design library.
#include <gtest/gtest.h>

#include "export/svg.hpp"
#include "fixtures.hpp"
#include "import/outline_commands.hpp"
#include "import/svg_import.hpp"
#include "model/contours.hpp"
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
  const std::string text = refusal_of([&] { shape_of(elements); });
  return text.substr(text.find("drawing.svg") + 11);
}

TEST(Svg, ErrorsNameTheFileAndTheElement) {
  EXPECT_EQ(refusal("<g>\n<text>A</text></g>"),
            ": line 2: <text> is not supported; convert the text to paths");
  EXPECT_EQ(refusal("<path fill='none' d='M0 0H9V9Z'/>"),
            ": draws nothing; fill or stroke a path of it");
}

// A glyph that is written as SVG and read again is the same.
TEST(Svg, WhatIsWrittenIsRead) {
  Project project;
  run(project, {{"do", "add_glyph"}, {"glyph", "a"}});
  run(project, Value::parse(R"({"do": "set_strokes", "glyph": "a", "strokes":
      [{"nib": "ellipse:120,40,30", "points":
      [[100,0],[300,600],[500,100],[200,300]]}]})"));
  const gen::Outline before = outline_of(project, *project.glyph("a"));
  const TemporaryFolder folder;
  write_text(folder.path() / "a.svg", svg_document(before, "a"));
  OutlineUse use;
  use.grid = 0;
  const gen::Outline read = read_svg(folder.path() / "a.svg", DrawingPlace());
  for (const Value& command : commands_for_outline(project, "b", read, use)) {
    run(project, command);
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
