// Distances against brute force, for every kind of shape.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "glyph_outlines.hpp"
#include "shape/flatten.hpp"
#include "shape/neighbourhood.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {
namespace test {
namespace {

// A reference without Clipper: cuts every edge of the raw contours at
// crossings; a piece is border if the winding number is zero on exactly one
// side.
class Reference {
 public:
  explicit Reference(const Outline& outline) {
    for (const Contour& contour : outline.contours) {
      const std::vector<Point> points = flatten(contour);
      for (size_t i = 0; i < points.size(); ++i) {
        const Edge edge{points[i], points[(i + 1) % points.size()]};
        if (length(edge) > 0) {
          raw_.push_back(edge);
        }
      }
    }
    for (const Edge& edge : raw_) {
      cut(edge);
    }
  }

  double distance(double x, double y) const {
    double best = std::numeric_limits<double>::infinity();
    for (const Edge& e : border_) {
      const double dx = e.b.x - e.a.x;
      const double dy = e.b.y - e.a.y;
      double t = ((x - e.a.x) * dx + (y - e.a.y) * dy) / (dx * dx + dy * dy);
      t = std::min(1.0, std::max(0.0, t));
      best = std::min(best, std::hypot(x - e.a.x - t * dx, y - e.a.y - t * dy));
    }
    return winding(x, y) != 0 ? best : -best;
  }

 private:
  static double length(const Edge& e) {
    return std::hypot(e.b.x - e.a.x, e.b.y - e.a.y);
  }

  int winding(double x, double y) const {
    int sum = 0;
    for (const Edge& e : raw_) {
      if ((e.a.y <= y) != (e.b.y <= y) &&
          e.a.x + (y - e.a.y) * (e.b.x - e.a.x) / (e.b.y - e.a.y) > x) {
        sum += e.b.y > e.a.y ? 1 : -1;
      }
    }
    return sum;
  }

  void cut(const Edge& e) {
    const double rx = e.b.x - e.a.x;
    const double ry = e.b.y - e.a.y;
    std::vector<double> at = {0, 1};
    for (const Edge& o : raw_) {
      const double sx = o.b.x - o.a.x;
      const double sy = o.b.y - o.a.y;
      const double cross = rx * sy - ry * sx;
      const double qx = o.a.x - e.a.x;
      const double qy = o.a.y - e.a.y;
      if (std::fabs(cross) > 1e-12) {
        const double t = (qx * sy - qy * sx) / cross;
        const double u = (qx * ry - qy * rx) / cross;
        if (t > 0 && t < 1 && u > -1e-9 && u < 1 + 1e-9) {
          at.push_back(t);
        }
      } else {
        // Parallel: the ends of the other may lie on this one.
        for (const Point& p : {o.a, o.b}) {
          const double t =
              ((p.x - e.a.x) * rx + (p.y - e.a.y) * ry) / (rx * rx + ry * ry);
          if (t > 0 && t < 1) {
            at.push_back(t);
          }
        }
      }
    }
    std::sort(at.begin(), at.end());
    for (size_t i = 0; i + 1 < at.size(); ++i) {
      keep({{e.a.x + rx * at[i], e.a.y + ry * at[i]},
            {e.a.x + rx * at[i + 1], e.a.y + ry * at[i + 1]}});
    }
  }

  void keep(const Edge& piece) {
    const double size = length(piece);
    if (size < 1e-9) {
      return;
    }
    const double nx = -(piece.b.y - piece.a.y) / size * 1e-4;
    const double ny = (piece.b.x - piece.a.x) / size * 1e-4;
    // Off the middle, to avoid rows of corners.
    const double x = piece.a.x + (piece.b.x - piece.a.x) * 0.4871;
    const double y = piece.a.y + (piece.b.y - piece.a.y) * 0.4871;
    if ((winding(x + nx, y + ny) != 0) != (winding(x - nx, y - ny) != 0)) {
      border_.push_back(piece);
    }
  }

  std::vector<Edge> raw_;
  std::vector<Edge> border_;
};

struct Case {
  std::string name;
  Outline outline;
};

std::vector<Point> star(double radius) {
  std::vector<Point> points;
  for (int i = 0; i < 5; ++i) {
    const double angle = 0.3 + i * 4 * 3.14159265358979 / 5;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

std::vector<Case> cases() {
  std::vector<Case> all = {
      {"rectangle", outline({rectangle(0, 0, 300, 200)})},
      {"clockwise", outline({rectangle(300, 0, 0, 200)})},
      {"overlapping",
       outline({rectangle(0, 0, 200, 200), rectangle(100, 100, 300, 300)})},
      {"crossed",
       outline({rectangle(0, 80, 300, 120), rectangle(130, -50, 170, 250)})},
      {"abutting",
       outline({rectangle(0, 0, 100, 200), rectangle(100, 0, 300, 200)})},
      {"same twice",
       outline({rectangle(0, 0, 99, 99), rectangle(0, 0, 99, 99)})},
      {"touching corners",
       outline({rectangle(0, 0, 100, 100), rectangle(100, 100, 200, 200)})},
      {"hole",
       outline({rectangle(0, 0, 300, 300), rectangle(200, 100, 100, 200)})},
      {"nested, same direction",
       outline({rectangle(0, 0, 300, 300), rectangle(100, 100, 200, 200)})},
      {"island in a hole",
       outline({circle(0, 0, 200), circle(0, 0, -120), circle(10, 5, 60)})},
      {"pentagram", outline({polygon(star(250))})},
      {"figure of eight",
       outline({polygon({{0, 0}, {200, 200}, {200, 0}, {0, 200}})})},
      {"circle", outline({circle(100, 50, 150)})},
      {"circles", outline({circle(0, 0, 100), circle(120, 10, 90)})},
      {"speck on a wall",
       outline({rectangle(0, 0, 300, 10), rectangle(100, 10, 100.5, 10.25)})},
      {"needle", outline({polygon({{0, 0}, {400, 0.2}, {0, 0.4}})})},
      {"slit", outline({polygon({{0, 0},
                                 {300, 0},
                                 {300, 300},
                                 {150.05, 300},
                                 {150, 10},
                                 {149.95, 300},
                                 {0, 300}})})},
      {"far away", outline({rectangle(14000, -14900, 14900, -14000)})}};
  const std::vector<uint32_t> letters = {'a', 'g', '&', '@', '8', '%'};
  for (const char* file : {kDejaVuSans, kLiberationSerif, kRoboto}) {
    const std::vector<Outline> glyphs = load_outlines(file, 0, letters);
    for (size_t i = 0; i < glyphs.size(); ++i) {
      all.push_back(
          {std::string(file) + " " + static_cast<char>(letters[i]), glyphs[i]});
    }
  }
  const std::vector<Outline> hanzi =
      load_outlines(kNotoSansCjk, 2, {0x9F8D, 0x6C38});
  all.push_back({"dragon", hanzi[0]});
  all.push_back({"ever", hanzi[1]});
  return all;
}

// Random points around the shape, and very close to its corners.
std::vector<Point> probes(const Shape& shape, size_t count) {
  std::mt19937 random(7);
  const Box& box = shape.box();
  std::uniform_real_distribution<double> x(box.x0 - 100, box.x1 + 100);
  std::uniform_real_distribution<double> y(box.y0 - 100, box.y1 + 100);
  std::uniform_real_distribution<double> near(-0.01, 0.01);
  std::vector<Point> points;
  for (size_t i = 0; i < count; ++i) {
    points.push_back({x(random), y(random)});
    // Integer u: the corners of fonts and the samples of cells.
    points.push_back({std::round(x(random)), std::round(y(random))});
    const Edge& edge = shape.edges()[random() % shape.edges().size()];
    points.push_back({edge.a.x + near(random), edge.a.y + near(random)});
    points.push_back({x(random), edge.a.y});
  }
  return points;
}

// Coordinates are rounded to 1/65536 u, and so are points where edges cross.
constexpr double kRounding = 4.0 / 65536;

TEST(Shape, DistancesAreThoseOfBruteForce) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Shape shape(c.outline);
    const Reference reference(c.outline);
    for (const Point& p : probes(shape, 100)) {
      ASSERT_NEAR(shape.distance(p.x, p.y), reference.distance(p.x, p.y),
                  kRounding)
          << p.x << ", " << p.y;
    }
  }
}

// Only the union's border counts.
TEST(Shape, NothingIsMeasuredToEdgesInside) {
  const Shape cross(
      outline({rectangle(0, 80, 300, 120), rectangle(130, -50, 170, 250)}));
  EXPECT_NEAR(cross.distance(150, 100), std::hypot(20, 20), 1e-9);
  const Shape overlap(
      outline({rectangle(0, 0, 200, 200), rectangle(100, 100, 300, 300)}));
  EXPECT_NEAR(overlap.distance(150, 150), std::hypot(50, 50), 1e-9);
  const Shape nested(
      outline({rectangle(0, 0, 300, 300), rectangle(100, 100, 200, 200)}));
  EXPECT_NEAR(nested.distance(150, 150), 150, 1e-9);
  const Shape abutting(
      outline({rectangle(0, 0, 100, 200), rectangle(100, 0, 200, 200)}));
  EXPECT_NEAR(abutting.distance(100, 100), 100, 1e-9);
}

TEST(Shape, BoxIsTheInk) {
  const Shape shape(
      outline({rectangle(10, 20, 200, 150), rectangle(50, 50, 60, 60)}));
  EXPECT_EQ(shape.box().x0, 10);
  EXPECT_EQ(shape.box().y0, 20);
  EXPECT_EQ(shape.box().x1, 200);
  EXPECT_EQ(shape.box().y1, 150);
}

TEST(Shape, ContoursWithoutAreaFillNothing) {
  const std::vector<Outline> nothing = {
      outline({}),
      outline({Contour()}),
      outline({polygon({{5, 5}})}),
      outline({polygon({{5, 5}, {5, 5}, {5, 5}, {5, 5}})}),
      outline({polygon({{0, 0}, {100, 0}})}),
      outline({polygon({{0, 0}, {100, 100}, {50, 50}})}),
      outline({polygon({{0, 0}, {1e-6, 0}, {0, 1e-6}})})};
  for (const Outline& o : nothing) {
    const Shape shape(o);
    EXPECT_TRUE(shape.empty());
    EXPECT_EQ(shape.box().x1, 0);
    EXPECT_FALSE(shape.inside(5, 5));
    EXPECT_EQ(shape.distance(0, 0), -std::numeric_limits<double>::infinity());
  }
}

TEST(Shape, DegenerateContoursDoNotHarmTheRest) {
  const Shape shape(
      outline({rectangle(0, 0, 100, 100), Contour(), polygon({{50, 50}}),
               polygon({{-50, 50}, {150, 50}})}));
  EXPECT_NEAR(shape.distance(50, 50), 50, 1e-9);
  EXPECT_NEAR(shape.distance(-40, 50), -40, 1e-9);
}

TEST(Shape, RefusesCoordinatesThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Shape(outline({rectangle(0, 0, nan, 10)})), GeometryError);
  EXPECT_THROW(Shape(outline({rectangle(0, 0, 1e12, 10)})), GeometryError);
}

TEST(Shape, CrossingsAlternate) {
  const Shape shape(
      outline({rectangle(0, 0, 300, 300), rectangle(200, 100, 100, 200)}));
  std::vector<double> crossings;
  shape.crossings(150, crossings);
  EXPECT_EQ(crossings, (std::vector<double>{0, 100, 200, 300}));
  shape.crossings(-1, crossings);
  EXPECT_TRUE(crossings.empty());
}

// Random squares, each made from its parent's list as in a quadtree.
void check_neighbourhood(const Shape& shape, std::mt19937& random) {
  const Box& box = shape.box();
  std::uniform_real_distribution<double> x(box.x0 - 90, box.x1 + 90);
  std::uniform_real_distribution<double> y(box.y0 - 90, box.y1 + 90);
  Square square{std::floor(x(random)) - 64, std::floor(y(random)) - 64, 128};
  Neighbourhood truth(shape, square);
  for (; square.size >= 1; square.size /= 2) {
    truth = truth.part(square);
    std::uniform_real_distribution<double> offset(0, square.size);
    double least = std::numeric_limits<double>::infinity();
    for (int row = 0; row <= 4; ++row) {
      const double py = square.y + square.size * row / 4;
      double d[41];
      truth.distances(square.x, py, square.size / 40, 41, d);
      for (int i = 0; i <= 40; ++i) {
        const double px = square.x + square.size / 40 * i;
        const double exact = shape.distance(px, py);
        ASSERT_NEAR(d[i], exact, 1e-7) << px << ", " << py;
        ASSERT_NEAR(truth.distance(px, py), exact, 1e-7);
        least = std::min(least, std::fabs(exact));
      }
    }
    // The clearance is at most the least distance of the points, and no point
    // of the square is farther than size / 7 from one of them.
    ASSERT_LE(truth.clearance(), least + 1e-7);
    ASSERT_GE(truth.clearance(), least - square.size / 7);
    square.x += random() % 2 == 0 ? 0 : square.size / 2;
    square.y += random() % 2 == 0 ? 0 : square.size / 2;
  }
}

TEST(Neighbourhood, KnowsAllThatMattersInItsSquare) {
  std::mt19937 random(3);
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Shape shape(c.outline);
    for (int i = 0; i < 10; ++i) {
      check_neighbourhood(shape, random);
    }
  }
}

TEST(Neighbourhood, ListsShrink) {
  const Shape shape(outline({circle(0, 0, 300)}));
  const Neighbourhood whole(shape, {-300, -300, 600});
  const Neighbourhood part = whole.part({280, 0, 16});
  EXPECT_EQ(whole.edge_count(), shape.edges().size());
  EXPECT_LT(part.edge_count(), whole.edge_count() / 10);
}

TEST(Neighbourhood, ClearanceIsZeroWhereTheEdgePasses) {
  const Shape shape(outline({rectangle(0, 0, 100, 100)}));
  EXPECT_EQ(Neighbourhood(shape, {-8, 40, 16}).clearance(), 0);
  EXPECT_NEAR(Neighbourhood(shape, {40, 40, 16}).clearance(), 40, 1e-9);
  EXPECT_NEAR(Neighbourhood(shape, {103, 104, 8}).clearance(), 5, 1e-9);
}

}  // namespace
}  // namespace test
}  // namespace inkcell::gen
