// Commands: effects and errors.
#include <gtest/gtest.h>

#include "fixtures.hpp"
#include "model/commands.hpp"
#include "model/contours.hpp"
#include "shape/shape.hpp"

namespace inkcell::design::test {
namespace {

const char* const kSquare = R"([[0, 0], [500, 0], [500, 500], [0, 500]])";

class Commands : public testing::Test {
 protected:
  Commands() { run(R"({"do": "add_glyph", "glyph": "a", "width": 500})"); }

  void run(const std::string& command) {
    test::run(project_, Value::parse(command));
  }

  std::string refusal_of(const std::string& command) {
    return test::refusal_of([&] { run(command); });
  }

  void add_square() {
    run(std::string(R"({"do": "add_contour", "glyph": "a", "points": )") +
        kSquare + "}");
  }

  double area_at(const char* glyph, double x, double y) {
    const gen::Shape shape(outline_of(project_, *project_.glyph(glyph)));
    return shape.distance(x * 1.024, y * 1.024);
  }

  Project project_;
};

TEST_F(Commands, DrawAndMoveASquare) {
  add_square();
  EXPECT_NEAR(area_at("a", 250, 250), 256, 1e-3);
  run(R"({"do": "move_points", "glyph": "a", "points": [[0,1],[0,2],[0,2]],
          "dx": 100})");
  EXPECT_EQ(project_.glyph("a")->contours[0].points[2].x, 600);
  EXPECT_GT(area_at("a", 590, 250), 0);
}

TEST_F(Commands, LeaveTheProjectAsItWasIfTheyFail) {
  add_square();
  const GlyphPointer before = project_.glyph("a");
  EXPECT_NE(refusal_of(R"({"do": "set_point", "glyph": "a", "contour": 0,
                          "point": 0, "type": "offcurve"})"),
            "");
  EXPECT_EQ(project_.glyph("a"), before);
}

TEST_F(Commands, NameWhatIsWrongAndWhatIsAllowed) {
  add_square();
  EXPECT_EQ(refusal_of(R"({"do": "fly"})").substr(0, 34),
            "command 'fly': is not known; there");
  EXPECT_EQ(refusal_of(R"({"do": "set_advance", "glyph": "a", "width": -1})"),
            "command 'set_advance', glyph 'a': the advance would be below 0");
  EXPECT_EQ(refusal_of(R"({"do": "set_advance", "glyph": "a"})"),
            "command 'set_advance', glyph 'a': \"width\" is missing");
  EXPECT_EQ(refusal_of(R"({"do": "set_advance", "glyph": "b", "width": 1})"),
            "command 'set_advance', glyph 'b': there is no such glyph; add it "
            "with add_glyph");
  EXPECT_EQ(
      refusal_of(R"({"do": "delete_contour", "glyph": "a", "contour": 3})"),
      "command 'delete_contour', glyph 'a': \"contour\" is 3, allowed are "
      "0..0");
}

TEST_F(Commands, CarryOutABatchAsOneStep) {
  const Project before = project_;
  const Change change = change_of(project_, Value::parse(R"({"do": "batch",
      "commands": [{"do": "set_advance", "glyph": "a", "width": 1},
                   {"do": "add_glyph", "glyph": "b", "width": 2},
                   {"do": "set_advance", "glyph": "a", "width": 3}]})"));
  EXPECT_EQ(change.glyphs.size(), 2u);
  project_.apply(change);
  EXPECT_EQ(project_.glyph("a")->width, 3);
  EXPECT_EQ(project_.glyph("b")->width, 2);
  project_.revert(change);
  EXPECT_EQ(project_.find("b"), nullptr);
  EXPECT_EQ(project_.glyph("a"), before.glyph("a"));
  EXPECT_NE(refusal_of(R"({"do": "batch", "commands": [
      {"do": "set_advance", "glyph": "a", "width": 9}, {"do": "none"}]})"),
            "");
  EXPECT_EQ(project_.glyph("a"), before.glyph("a"));
}

TEST_F(Commands, RefuseAGlyphThatContainsItself) {
  run(R"({"do": "add_glyph", "glyph": "b"})");
  run(R"({"do": "add_component", "glyph": "b", "base": "a"})");
  EXPECT_NE(refusal_of(R"({"do": "add_component", "glyph": "a",
                          "base": "b"})"),
            "");
  EXPECT_NE(refusal_of(R"({"do": "delete_glyph", "glyph": "a"})"), "");
}

TEST_F(Commands, RenameReferencesToo) {
  run(R"({"do": "add_glyph", "glyph": "b"})");
  run(R"({"do": "add_component", "glyph": "b", "base": "a"})");
  run(R"({"do": "rename_glyph", "glyph": "a", "to": "c"})");
  EXPECT_EQ(project_.find("a"), nullptr);
  EXPECT_EQ(project_.glyph("c")->name, "c");
  EXPECT_EQ(project_.glyph("b")->components[0].base, "c");
}

// Strokes that no longer give the contours are not kept.
TEST_F(Commands, DropASourceThatDisagrees) {
  run(R"({"do": "set_strokes", "glyph": "a", "strokes": [
      {"nib": "ellipse:80,80,0", "points": [[0, 0], [300, 0]]}]})");
  const auto has_source = [this] {
    return project_.glyph("a")->lib.contains("org.inkcell.strokes");
  };
  run(R"({"do": "set_advance", "glyph": "a", "width": 300})");
  EXPECT_TRUE(has_source());
  run(R"({"do": "move_points", "glyph": "a", "points": [[0, 0]], "dx": 9})");
  EXPECT_FALSE(has_source());
}

TEST_F(Commands, RenameInKerningGroupsOrderAndTrees) {
  run(R"({"do": "add_glyph", "glyph": "b"})");
  run(R"({"do": "set_glyph_lib", "glyph": "b", "key": "org.inkcell.tree",
          "value": {"op": "union", "parts": [{"glyph": "a"},
                                             {"glyph": "a"}]}})");
  run(R"({"do": "set_group", "group": "public.kern1.a", "value": ["a", "b"]})");
  run(R"({"do": "set_kerning", "left": "a", "right": "a", "value": -9})");
  run(R"({"do": "set_lib", "key": "public.glyphOrder", "value": ["b", "a"]})");
  const Project before = project_;
  const Change change =
      change_of(project_, Value::parse(R"({"do": "rename_glyph", "glyph": "a",
                                 "to": "c"})"));
  project_.apply(change);
  EXPECT_EQ(project_.font->groups["public.kern1.a"], Value({"c", "b"}));
  EXPECT_EQ(project_.font->kerning, Value::parse(R"({"c": {"c": -9}})"));
  EXPECT_EQ(glyph_order(project_), (std::vector<std::string>{"b", "c"}));
  EXPECT_EQ(project_.glyph("b")->lib["org.inkcell.tree"]["parts"][1]["glyph"],
            "c");
  project_.revert(change);
  EXPECT_EQ(*project_.font, *before.font);
  EXPECT_EQ(*project_.glyph("b"), *before.glyph("b"));
}

TEST_F(Commands, DecomposeTurnsReflectedContoursOver) {
  add_square();
  run(R"({"do": "add_glyph", "glyph": "b"})");
  run(R"({"do": "add_component", "glyph": "b", "base": "a",
          "matrix": [-1, 0, 0, 1, 1000, 0]})");
  const double inside = area_at("b", 750, 250);
  run(R"({"do": "decompose", "glyph": "b"})");
  EXPECT_TRUE(project_.glyph("b")->components.empty());
  EXPECT_NEAR(inside, 256, 1e-3);
  EXPECT_NEAR(area_at("b", 750, 250), 256, 1e-3);
}

// Lines, cubics, quadratics with implied points: reversing twice restores the
// curve.
TEST_F(Commands, ReverseTwiceIsNothing) {
  const Value contours = Value::parse(R"([
      [[0,0],[500,0],[500,500],[0,500]],
      [[0,0,"offcurve"],[0,9,"offcurve"],[9,9,"offcurve"]],
      [[10,0,"curve"],[0,5],[3,9,"offcurve"],[4,9,"offcurve"],[9,9,"curve"],
       [9,2,"offcurve"]],
      [[0,0,"move"],[4,4,"offcurve"],[8,0,"qcurve"],[9,9]]])");
  for (const Value& value : contours) {
    const PointContour contour = parse_contour(value);
    const PointContour back = reversed(contour);
    check_contour(back);
    EXPECT_EQ(contour_value(reversed(back)), contour_value(contour));
  }
}

TEST_F(Commands, KeepTheCurveWhenItIsReversed) {
  const PointContour contour = parse_contour(Value::parse(
      R"([[10,0,"curve"],[0,500],[300,900,"offcurve"],[400,900,"offcurve"],
          [900,900,"curve"],[900,200,"offcurve"]])"));
  const gen::Contour there = to_segments(contour, 1);
  const gen::Contour back = to_segments(reversed(contour), 1);
  const gen::Shape a({{there}});
  const gen::Shape b({{back}});
  for (double x = 0; x < 1000; x += 37) {
    EXPECT_NEAR(a.distance(x, x / 2), b.distance(x, x / 2), 0.02);
  }
}

// The bytes are a PNG's first ones, and one more.
TEST_F(Commands, PutAPictureBehindAGlyph) {
  run(R"({"do": "set_image", "glyph": "a", "file": "a.png",
          "data": "iVBORw0KGgoB", "matrix": {"scale": 2, "move": [10, -20]}})");
  const std::optional<GlyphImage> image = project_.glyph("a")->image;
  ASSERT_TRUE(image);
  EXPECT_EQ(image->file, "a.png");
  EXPECT_EQ(image->matrix.yy, 2);
  EXPECT_EQ(image->matrix.dy, -20);
  const std::vector<uint8_t> bytes = {0x89, 'P',  'N',  'G', 0x0d,
                                      0x0a, 0x1a, 0x0a, 1};
  EXPECT_EQ(*project_.font->images.at("a.png"), bytes);
  // The bytes are already there.
  run(R"({"do": "set_image", "glyph": "a", "file": "a.png"})");
  EXPECT_EQ(project_.glyph("a")->image->matrix.dy, 0);
  run(R"({"do": "set_image", "glyph": "a"})");
  EXPECT_FALSE(project_.glyph("a")->image);
  EXPECT_TRUE(project_.font->images.empty());
}

TEST_F(Commands, SayWhatIsWrongWithAPicture) {
  const auto refusal = [this](const std::string& arguments) {
    return refusal_of(R"({"do": "set_image", "glyph": "a", )" + arguments +
                      "}");
  };
  const std::string begin = "command 'set_image', glyph 'a': ";
  EXPECT_EQ(refusal(R"("file": "b.png")"),
            begin +
                "images/b.png is missing; give its bytes in Base64 as "
                "\"data\"");
  for (const char* name : {"b.jpg", "../b.png", ".png", ".b.png", ""}) {
    EXPECT_EQ(refusal(std::string(R"("file": ")") + name + "\"")
                  .rfind(begin + "\"file\" is '" + name + "'; ", 0),
              0u)
        << name;
  }
  EXPECT_EQ(refusal(R"("file": "b.png", "data": "R0lGODlh")"),
            begin + "\"data\" is no PNG in Base64");
  run(R"({"do": "add_glyph", "glyph": "b"})");
  run(R"({"do": "set_image", "glyph": "b", "file": "b.png",
          "data": "iVBORw0KGgoB"})");
  EXPECT_EQ(refusal(R"("file": "b.png", "data": "iVBORw0KGgoC")"),
            begin +
                "images/b.png is another picture already; choose another "
                "name");
}

TEST_F(Commands, SetBearingsMovesInkAndLeavesUsersInPlace) {
  add_square();
  run(R"({"do": "add_glyph", "glyph": "b", "width": 500})");
  run(R"({"do": "add_component", "glyph": "b", "base": "a",
          "matrix": {"scale": 0.5, "move": [100, 0]}})");
  run(R"({"do": "set_bearings", "glyph": "a", "left": 40, "right": 30})");
  EXPECT_EQ(project_.glyph("a")->width, 570);
  EXPECT_EQ(project_.glyph("a")->contours[0].points[0].x, 40);
  EXPECT_EQ(project_.glyph("b")->components[0].matrix.dx, 80);
  EXPECT_NE(refusal_of(R"({"do": "set_bearings", "glyph": "a", "left": -700})"),
            "");
}

TEST_F(Commands, OffsetKeepsPointsAndMovesEdges) {
  add_square();
  const std::string offset = R"({"do": "offset", "glyph": "a", "by": 20)";
  run(offset + "}");
  const PointContour grown = project_.glyph("a")->contours[0];
  EXPECT_EQ(grown.points.size(), 4u);
  EXPECT_EQ(grown.points[0].x, -20);
  EXPECT_EQ(grown.points[2].y, 520);
  run(offset + R"(, "side": "inside"})");
  EXPECT_EQ(project_.glyph("a")->contours[0].points[2].y, 500);
  run(offset + R"(, "side": "both"})");
  EXPECT_EQ(project_.glyph("a")->contours.size(), 2u);
  EXPECT_LT(area_at("a", 250, 250), 0);
  EXPECT_NEAR(area_at("a", 250, 0), 20 * 1.024, 0.1);
  EXPECT_NE(refusal_of(offset + R"(, "side": "up"})"), "");
}

// A square ring: stems of 100, a counter of 300.
TEST_F(Commands, ChangeWeightKeepsHeightsAndWhatIsAsked) {
  add_square();
  run(R"({"do": "add_contour", "glyph": "a", "points":
          [[100, 100], [100, 400], [400, 400], [400, 100]]})");
  const Project before = project_;
  const auto weigh = [&](const char* more) {
    project_ = before;
    run(std::string(R"({"do": "change_weight", "glyph": "a", "by": 40)") +
        more + "}");
    const Glyph& glyph = *project_.glyph("a");
    const auto& outer = glyph.contours[0].points;
    const auto& inner = glyph.contours[1].points;
    return std::vector<double>{outer[0].y, outer[2].y, outer[0].x,
                               outer[1].x, inner[0].x, inner[2].x,
                               inner[0].y, inner[2].y, glyph.width};
  };
  using Values = std::vector<double>;
  EXPECT_EQ(weigh(""), (Values{0, 500, 0, 580, 140, 440, 124, 376, 580}));
  EXPECT_EQ(weigh(R"(, "counters": 0, "bars": 20)"),
            (Values{0, 500, 0, 500, 140, 360, 120, 380, 500}));
  EXPECT_EQ(weigh(R"(, "advance": "keep")"),
            (Values{0, 500, -40, 540, 100, 400, 124, 376, 500}));
  EXPECT_NE(refusal_of(R"({"do": "change_weight", "glyph": "a", "by": 4000})"),
            "");
}

}  // namespace
}  // namespace inkcell::design::test
