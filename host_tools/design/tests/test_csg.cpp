// Combined shapes against their distances, point by point.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "component/blend_field.hpp"
#include "component/csg.hpp"
#include "component/tree.hpp"
#include "fixtures.hpp"
#include "journal/session.hpp"
#include "model/arguments.hpp"
#include "model/contours.hpp"

namespace inkcell::design::test {
namespace {

// Its points are whole units, 1 u here.
gen::Shape shape_of_tree(const Project& project, const Value& tree) {
  Glyph glyph;
  glyph.contours = contours_of_tree(project, 0, tree);
  return gen::Shape(outline_of(project, glyph));
}

class Csg : public testing::Test {
 protected:
  Csg() {
    run({{"do", "set_info"}, {"key", "unitsPerEm"}, {"value", 1024u}});
    run({{"do", "add_glyph"}, {"glyph", "box"}});
    run(Value::parse(R"({"do": "add_contour", "glyph": "box",
        "points": [[0,0],[300,0],[300,300],[0,300]]})"));
    run({{"do", "add_glyph"}, {"glyph", "disc"}});
    run(Value::parse(R"({"do": "set_strokes", "glyph": "disc", "strokes":
        [{"nib": "ellipse:300", "points": [[0,0]]}], "grid": 0})"));
    run({{"do", "add_glyph"}, {"glyph", "out"}});
  }

  void run(const Value& command) { test::run(project_, command); }

  gen::Shape shape(const char* glyph) const {
    return gen::Shape(outline_of(project_, *project_.glyph(glyph)));
  }

  Project project_;
};

TEST_F(Csg, AStrokeOfOnePointIsItsNib) {
  const gen::Shape disc = shape("disc");
  for (int i = 0; i < 100; ++i) {
    EXPECT_NEAR(disc.distance(150 * std::cos(i), 150 * std::sin(i)), 0, 0.25);
  }
  EXPECT_EQ(project_.glyph("disc")->lib.count("org.inkcell.strokes"), 1u);
}

// Turned, scaled, reflected parts: the distances tell the side of a point.
TEST_F(Csg, RandomTreesHaveTheirPointsOnTheRightSide) {
  std::mt19937 random(7);
  const auto within = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const char* const ops[] = {"union", "intersection", "difference"};
  constexpr double kRounding = 1;  // of points, and of handles of cut curves
  for (int round = 0; round < 60; ++round) {
    Value parts = Value::array();
    std::vector<gen::Shape> shapes;
    const int count = 2 + static_cast<int>(random() % 5);
    for (int i = 0; i < count; ++i) {
      const double a = within(0, 6.3);
      const double s = within(0.5, 1.5);
      const double f = random() % 2 == 0 ? 1 : -1;
      const Value leaf = {
          {"glyph", random() % 2 == 0 ? "box" : "disc"},
          {"matrix",
           {s * std::cos(a), s * std::sin(a), -f * s * std::sin(a),
            f * s * std::cos(a), within(0, 300), within(0, 300)}}};
      parts.push_back(leaf);
      const Value alone = {{"op", "union"},
                           {"parts", Value::array({leaf, leaf})}};
      shapes.push_back(shape_of_tree(project_, alone));
    }
    const std::string op = ops[random() % 3];
    const gen::Shape made =
        shape_of_tree(project_, {{"op", op}, {"parts", parts}});
    for (int i = 0; i < 200; ++i) {
      const double x = within(-400, 800);
      const double y = within(-400, 800);
      double truth = shapes[0].distance(x, y);
      for (size_t k = 1; k < shapes.size(); ++k) {
        const double d = shapes[k].distance(x, y);
        truth = op == "union"          ? std::max(truth, d)
                : op == "intersection" ? std::min(truth, d)
                                       : std::min(truth, -d);
      }
      if (std::fabs(truth) > kRounding) {
        EXPECT_EQ(made.inside(x, y), truth > 0) << op << " round " << round;
      }
    }
  }
}

TEST_F(Csg, ABlendFollowsItsFormulaAndIsADistanceAgain) {
  constexpr double kRadius = 60;
  const gen::Shape a = shape("box");
  const Value moved = Value::parse(
      R"({"op": "union", "parts": [
          {"glyph": "disc", "matrix": [1,0,0,1,380,250]},
          {"glyph": "disc", "matrix": [1,0,0,1,380,250]}]})");
  const gen::Shape b = shape_of_tree(project_, moved);
  const gen::Shape made = combine(a, b, Combination::blend, kRadius);
  ASSERT_FALSE(made.empty());
  const BlendField field(a, b, kRadius);
  for (const gen::Edge& edge : made.edges()) {
    EXPECT_NEAR(field.distance(edge.a), 0, 1.0 / 16);
  }
  // The right edge of the box crosses the disc by more than a right angle.
  const double below = 250 - std::sqrt(150.0 * 150 - 80 * 80);
  for (const double step : {1.0, 10.0, 30.0}) {
    const Point p = {300 + step, below - step};
    const double da = a.distance(p.x, p.y);
    const double db = b.distance(p.x, p.y);
    const double h = kRadius - std::fabs(da - db);
    EXPECT_NEAR(field.swell(p), h * h / (4 * kRadius), 1e-9);
  }
  // Just off the edge its distance grows by 1 u per u, in the fillet, too.
  int steep = 0;
  for (size_t i = 0; i < made.edges().size(); i += 5) {
    const gen::Edge& edge = made.edges()[i];
    const double dx = edge.b.x - edge.a.x;
    const double dy = edge.b.y - edge.a.y;
    const double l = std::hypot(dx, dy);
    const double d = made.distance((edge.a.x + edge.b.x) / 2 - 0.2 * dy / l,
                                   (edge.a.y + edge.b.y) / 2 + 0.2 * dx / l);
    EXPECT_NEAR(d / 0.2, 1, 0.02);
    ++steep;
  }
  EXPECT_GT(steep, 100);
}

// A stem and a ring: points of the stem beyond the fillets stay, and all are
// whole.
TEST_F(Csg, ABlendKeepsWhatItsFilletsDoNotReach) {
  constexpr double kRadius = 60;
  const Value tree = Value::parse(R"({"op": "blend", "radius": 60, "parts": [
      {"glyph": "box", "matrix": [0.3,0,0,3,0,-200]},
      {"glyph": "disc", "matrix": [1,0,0,1,200,250]}]})");
  const std::vector<PointContour> contours =
      contours_of_tree(project_, 0, tree);
  ASSERT_EQ(contours.size(), 1u);
  std::set<std::pair<double, double>> points;
  for (const GlyphPoint& point : contours[0].points) {
    EXPECT_EQ(point.x, std::round(point.x));
    EXPECT_EQ(point.y, std::round(point.y));
    points.emplace(point.x, point.y);
  }
  for (const auto& corner : {std::pair(0.0, -200.0), std::pair(90.0, -200.0),
                             std::pair(90.0, 700.0), std::pair(0.0, 700.0)}) {
    EXPECT_EQ(points.count(corner), 1u) << corner.first;
  }
  const auto part = [this, &tree](size_t i) {
    const Value leaf = tree["parts"][i];
    return shape_of_tree(project_, {{"op", "union"}, {"parts", {leaf, leaf}}});
  };
  const gen::Shape a = part(0);
  const gen::Shape b = part(1);
  const BlendField field(a, b, kRadius);
  const gen::Shape made = shape_of_tree(project_, tree);
  for (const gen::Edge& edge : made.edges()) {
    EXPECT_NEAR(field.distance(edge.a), 0, 1.0);
  }
}

// A bar that begins inside a stem, side by side with the stem's edge.
TEST_F(Csg, ABlendActsInCornersAlone) {
  for (const double width : {0.3, 0.15}) {  // of the stem: 90 and 45 units
    const double right = 300 * width;
    const Value tree = {
        {"op", "blend"},
        {"radius", 60},
        {"parts",
         {{{"glyph", "box"}, {"matrix", {width, 0, 0, 3, 0, -200}}},
          {{"glyph", "box"}, {"matrix", {1, 0, 0, 1, 10, 100}}}}}};
    const gen::Shape made = shape_of_tree(project_, tree);
    EXPECT_EQ(made.box().x0, 0);
    EXPECT_EQ(made.box().x1, 310);
    for (double y = -199; y < 700; y += 7) {
      EXPECT_NEAR(made.distance(-1, y), -1, 1e-6) << y;
    }
    for (const double y : {400 + 5.0, 100 - 5.0}) {
      EXPECT_GT(made.distance(right + 5, y), 1) << "no fillet";
    }
    // Far from the corners the union stays.
    EXPECT_NEAR(made.distance(250, 401), -1, 1e-6);
    EXPECT_NEAR(made.distance(right + 1, 600), -1, 1e-6);
  }
}

// Neither bridges nor bulges between shapes that do not cross.
TEST_F(Csg, ABlendOfShapesThatDoNotCrossIsTheirUnion) {
  const Value tree = Value::parse(R"({"op": "blend", "radius": 60, "parts": [
      {"glyph": "box"}, {"glyph": "box", "matrix": [1,0,0,1,310,0]}]})");
  const std::vector<PointContour> contours =
      contours_of_tree(project_, 0, tree);
  ASSERT_EQ(contours.size(), 2u);
  EXPECT_EQ(contours[0].points.size(), 4u);
  EXPECT_EQ(contours[1].points.size(), 4u);
}

TEST_F(Csg, AGlyphFollowsItsParts) {
  run(Value::parse(R"({"do": "set_tree", "glyph": "out", "tree":
      {"op": "difference", "parts": [{"glyph": "box"}, {"glyph": "disc"}]}})"));
  run({{"do", "add_glyph"}, {"glyph", "far"}});
  run(Value::parse(R"({"do": "set_tree", "glyph": "far", "tree":
      {"op": "union", "parts": [{"glyph": "out"}, {"glyph": "box"}]}})"));
  Player player(project_);
  const auto right = [&player](const char* name) {
    return gen::Shape(
               outline_of(player.project(), *player.project().glyph(name)))
        .box()
        .x1;
  };
  player.play(Value::parse(R"({"do": "move_points", "glyph": "box",
      "points": [[0, 1], [0, 2]], "dx": 50})"));
  EXPECT_EQ(right("out"), 350);
  EXPECT_EQ(right("far"), 350);
  EXPECT_TRUE(player.undo());
  EXPECT_EQ(right("far"), 300);
  const Value circle = Value::parse(R"({"do": "set_tree", "glyph": "out",
      "tree": {"op": "union", "parts": [{"glyph": "far"},
                                        {"glyph": "box"}]}})");
  EXPECT_THROW(player.play(circle), Error);
  EXPECT_THROW(
      player.play(Value::parse(R"({"do": "delete_glyph", "glyph": "disc"})")),
      Error);
}

TEST_F(Csg, TreesAreCommandsThatCanBeUndone) {
  Player player(project_);
  player.play(Value::parse(R"({"do": "set_tree", "glyph": "out", "tree":
      {"op": "difference", "parts": [{"glyph": "box"}, {"glyph": "disc"}]}})"));
  const gen::Shape made(
      outline_of(player.project(), *player.project().glyph("out")));
  EXPECT_LT(made.distance(50, 50), -50);
  EXPECT_GT(made.distance(250, 250), 49);
  EXPECT_TRUE(player.undo());
  EXPECT_TRUE(player.project().glyph("out")->contours.empty());
}

TEST_F(Csg, ErrorsSayWhatIsAllowed) {
  const auto refusal = [this](const char* tree) {
    return refusal_of([&] { shape_of_tree(project_, Value::parse(tree)); });
  };
  EXPECT_EQ(refusal(R"({"op": "xor", "parts": []})"),
            "operator 'xor' of a tree is not known; use union, intersection, "
            "difference, exclusion or blend");
  EXPECT_EQ(refusal(R"({"op": "blend", "parts": []})"),
            "a blend has a \"radius\" above 0, in font units");
  EXPECT_NE(refusal(R"({"glyph": "none"})"), "");
}

// The memory of the walk grows with its box.
TEST_F(Csg, ABlendOfAnyRadiusIsRefusedOrFitsIntoMemory) {
  const Value command = Value::parse(R"({"do": "set_tree", "glyph": "out",
      "tree": {"op": "blend", "radius": 1e9, "parts":
               [{"glyph": "box"}, {"glyph": "disc"}]}})");
  EXPECT_EQ(refusal_of([&] { run(command); }),
            "command 'set_tree', glyph 'out': an edge is followed within 8 em "
            "by 8 em; make the glyph, or the radius of its blend, smaller");
}

TEST_F(Csg, PartsAreReflectedScaledTurnedAndMoved) {
  const auto placed = [](const char* matrix) {
    const Value command = {{"do", "x"}, {"matrix", Value::parse(matrix)}};
    return Arguments(command).matrix("matrix");
  };
  const Matrix reflected = placed(R"({"reflect": "x", "move": [10, 20]})");
  EXPECT_EQ(reflected.map(3, 4).x, 7);
  EXPECT_EQ(reflected.map(3, 4).y, 24);
  const Matrix turned = placed(R"({"scale": [2, 3], "turn": 90})");
  EXPECT_EQ(turned.map(1, 0).x, 0);
  EXPECT_EQ(turned.map(1, 0).y, 2);
  EXPECT_EQ(turned.map(0, 1).x, -3);
  EXPECT_EQ(placed(R"({"turn": -270, "reflect": "y"})").map(0, 1).x, 1);
  EXPECT_THROW(placed(R"({"mirror": "x"})"), Error);
  EXPECT_THROW(placed(R"({"turn": "left"})"), Error);
}

}  // namespace
}  // namespace inkcell::design::test
