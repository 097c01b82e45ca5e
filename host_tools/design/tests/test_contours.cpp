// Contours: direction, Boolean operations, conversion to cubics.
#include <gtest/gtest.h>

#include <cmath>

#include "component/contour_csg.hpp"
#include "component/csg.hpp"
#include "fixtures.hpp"
#include "import/outline_commands.hpp"
#include "model/contours.hpp"
#include "model/glyph_names.hpp"

namespace inkcell::design::test {
namespace {

constexpr const char* kFaces[] = {"dejavu/DejaVuSans.ttf",
                                  "lato/Lato-Regular.ttf"};

PointContour contour(const char* points) {
  return parse_contour(Value::parse(points));
}

gen::Shape shape_of(const std::vector<PointContour>& contours) {
  gen::Outline outline;
  for (const PointContour& each : contours) {
    outline.contours.push_back(to_segments(each, 1));
  }
  return gen::Shape(outline);
}

// The farthest that the border of one is from that of the other.
double difference(const gen::Shape& a, const gen::Shape& b) {
  double worst = 0;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const gen::Edge& edge : from->edges()) {
      worst = std::max(worst, std::fabs(to->distance(edge.a.x, edge.a.y)));
    }
  }
  return worst;
}

bool is_whole(const PointContour& each) {
  return std::all_of(each.points.begin(), each.points.end(),
                     [](const GlyphPoint& p) {
                       return p.x == std::round(p.x) && p.y == std::round(p.y);
                     });
}

class Faces : public testing::TestWithParam<const char*> {};

// A stroke or an outline over an imported letter adds ink: no hole.
TEST_P(Faces, DrawingOverALetterMakesNoHole) {
  Project project = face(GetParam(), "l,o", Composites::decompose);
  const GlyphPointer l = project.glyph("l");
  const gen::Shape before(outline_of(project, *l));
  const Value bar =
      Value::parse(R"([[[-300, 100], [900, 100], [900, 200], [-300, 200]]])");
  gen::Outline outline;
  outline.contours.push_back(to_segments(parse_contour(bar[0]), 1));
  for (const Value& command : commands_for_outline(project, "l", outline, {})) {
    run(project, command);
  }
  ASSERT_EQ(project.glyph("l")->contours.size(), l->contours.size() + 1);
  const gen::Shape after(outline_of(project, *project.glyph("l")));
  for (const gen::Edge& edge : before.edges()) {
    EXPECT_GE(after.distance(edge.a.x, edge.a.y), -0.01);
  }
  run(project, {{"do", "add_glyph"}, {"glyph", "bar"}});
  run(project, {{"do", "set_strokes"},
                {"glyph", "bar"},
                {"strokes", Value::parse(R"([{"nib": "ellipse:90,60,30",
                                     "points": [[0, 0], [500, 700]]}])")}});
  for (const PointContour& each : project.glyph("bar")->contours) {
    EXPECT_LT(twice_area(each), 0);
    EXPECT_TRUE(is_whole(each));
  }
}

TEST_P(Faces, CombinedContoursKeepTheirCurves) {
  const Project project = face(GetParam(), "O,e,g,R", Composites::decompose);
  const std::vector<PointContour>& a = project.glyph("O")->contours;
  for (const char* name : {"e", "g", "R"}) {
    Project other = project;
    run(other, {{"do", "transform"},
                {"glyph", name},
                {"matrix", Value::parse(R"({"move": [310, 70]})")}});
    const std::vector<PointContour>& b = other.glyph(name)->contours;
    const auto expect = [&](const char* operation, Combination combination) {
      const std::vector<PointContour> result = combined(a, b, operation);
      // New points are whole units, and so are the handles of cut curves.
      EXPECT_LT(difference(shape_of(result),
                           combine(shape_of(a), shape_of(b), combination)),
                1.3)
          << GetParam() << ' ' << name << ' ' << operation;
      size_t points = 0;
      for (const PointContour& each : result) {
        points += each.points.size();
        check_contour(each);
      }
      size_t before = 0;
      for (const auto* list : {&a, &b}) {
        for (const PointContour& each : *list) {
          before += each.points.size();
        }
      }
      EXPECT_LT(points, before + 40);
    };
    expect("union", Combination::unite);
    expect("intersection", Combination::intersect);
    expect("difference", Combination::subtract);
    const gen::Shape both =
        combine(shape_of(a), shape_of(b), Combination::intersect);
    EXPECT_LT(difference(
                  shape_of(combined(a, b, "exclusion")),
                  combine(combine(shape_of(a), shape_of(b), Combination::unite),
                          both, Combination::subtract)),
              1.3);
  }
}

TEST_P(Faces, CubicsKeepTheShape) {
  Project project = face(GetParam(), "a-z", Composites::decompose);
  const Project before = project;
  for (const auto& [name, glyph] : before.front().glyphs) {
    run(project, {{"do", "to_cubics"}, {"glyph", name}});
    const std::vector<PointContour>& cubics = project.glyph(name)->contours;
    for (const PointContour& each : cubics) {
      EXPECT_TRUE(is_whole(each));
      for (const GlyphPoint& point : each.points) {
        EXPECT_NE(point.type, PointType::qcurve) << name;
      }
    }
    if (!cubics.empty()) {
      EXPECT_LT(difference(shape_of(glyph->contours), shape_of(cubics)), 0.9)
          << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Contours, Faces, testing::ValuesIn(kFaces));

TEST(Combined, RectanglesWithACommonSideAreOne) {
  const auto result =
      combined({contour("[[0,0],[100,0],[100,50],[0,50]]")},
               {contour("[[100,0],[100,50],[180,50],[180,0]]")}, "union");
  ASSERT_EQ(result.size(), 1u);
  EXPECT_EQ(result[0].points.size(), 4u);
  EXPECT_EQ(twice_area(result[0]), 2 * 180 * 50);
}

TEST(Combined, UntouchedContoursStayAsTheyAre) {
  const PointContour far = contour(
      R"([[500.5,0],[600,0],[600,50,"offcurve"],[550,80,"qcurve","smooth"]])");
  const PointContour sketch = contour(R"([[0,0,"move"],[7,7]])");
  const auto result =
      combined({far, sketch, contour("[[0,0],[100,0],[100,50],[0,50]]")},
               {contour("[[20,-10],[40,-10],[40,90],[20,90]]")}, "difference");
  EXPECT_EQ(std::count(result.begin(), result.end(), far), 1);
  EXPECT_EQ(std::count(result.begin(), result.end(), sketch), 1);
  ASSERT_EQ(result.size(), 4u);
  EXPECT_EQ(combined({far}, {}, "union"), std::vector<PointContour>{far});
}

TEST(Combined, TheCommandSaysWhatIsAllowed) {
  Project project;
  run(project, {{"do", "add_glyph"}, {"glyph", "a"}});
  for (const auto& [op, contours, message] :
       {std::tuple("xor", "[]", "use union, intersection"),
        std::tuple("union", "[4]", "\"contours\" are numbers below 0")}) {
    const Value command = {{"do", "combine_contours"},
                           {"glyph", "a"},
                           {"op", op},
                           {"contours", Value::parse(contours)}};
    const std::string refusal = refusal_of([&] { run(project, command); });
    EXPECT_NE(refusal.find(message), std::string::npos) << refusal;
  }
}

TEST(GlyphNames, FollowTheList) {
  EXPECT_EQ(name_of_character(U'!'), "exclam");
  EXPECT_EQ(name_of_character(U'Q'), "Q");
  EXPECT_EQ(name_of_character(0x20AC), "Euro");
  EXPECT_EQ(name_of_character(0x2460), "uni2460");
  EXPECT_EQ(name_of_character(0x1F600), "u1F600");
  EXPECT_EQ(character_of_name("exclam"), char32_t{U'!'});
  EXPECT_EQ(character_of_name("eacute"), char32_t{0xE9});
  EXPECT_EQ(character_of_name("u1D538"), char32_t{0x1D538});
  EXPECT_EQ(character_of_name("uni2460"), char32_t{0x2460});
  for (const char* name : {"_part", "a.sc", "uni24", "uniform", ""}) {
    EXPECT_EQ(character_of_name(name), std::nullopt) << name;
  }
}

TEST(GlyphNames, GiveNewGlyphsTheirCodePoints) {
  Project project;
  run(project, {{"do", "add_glyph"}, {"glyph", "Q"}});
  EXPECT_EQ(project.glyph("Q")->unicodes, std::vector<char32_t>{U'Q'});
  run(project, {{"do", "add_glyph"},
                {"glyph", "x"},
                {"unicodes", Value::array({0x79u})}});
  run(project, {{"do", "add_glyph"}, {"glyph", "y"}});
  EXPECT_TRUE(project.glyph("y")->unicodes.empty());  // x has it
}

}  // namespace
}  // namespace inkcell::design::test
