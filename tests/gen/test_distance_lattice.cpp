// What the encoder of fields knows about a border: distances, chains, corners.
#include <gtest/gtest.h>

#include "shape/distance_lattice.hpp"

#include <cmath>
#include <random>
#include <set>

#include "glyph_outlines.hpp"

namespace inkcell {
namespace gen {
namespace test {
namespace {

// Its shape, and the truth in its box and 100 u around.
struct Subject {
  explicit Subject(const Outline& source)
      : shape(source),
        x0(static_cast<int>(std::floor(shape.box().x0)) - 100),
        y0(static_cast<int>(std::floor(shape.box().y0)) - 100),
        width(static_cast<int>(std::ceil(shape.box().x1)) + 100 - x0),
        height(static_cast<int>(std::ceil(shape.box().y1)) + 100 - y0),
        truth(shape, x0, y0, width, height) {}

  Shape shape;
  int x0;
  int y0;
  int width;
  int height;
  DistanceLattice truth;
};

// Chains hold every edge once and meet, one after the other, in the corners.
void expect_consistent(const DistanceLattice& truth) {
  const std::vector<Edge>& edges = truth.shape().edges();
  size_t sum = 0;
  for (const BorderChain& chain : truth.chains()) {
    EXPECT_GE(chain.edge_count, 1u);
    EXPECT_LT(chain.first_edge, edges.size());
    sum += chain.edge_count;
  }
  EXPECT_EQ(sum, edges.size());
  std::set<int> begun;
  std::set<int> ended;
  for (const Corner& corner : truth.corners()) {
    ASSERT_GE(corner.before, 0);
    ASSERT_GE(corner.after, 0);
    const auto after = static_cast<size_t>(corner.after);
    ASSERT_LT(after, truth.chains().size());
    ASSERT_LT(static_cast<size_t>(corner.before), truth.chains().size());
    const Point& start = edges[truth.chains()[after].first_edge].a;
    EXPECT_EQ(start.x, corner.at.x);
    EXPECT_EQ(start.y, corner.at.y);
    EXPECT_TRUE(begun.insert(corner.after).second);
    EXPECT_TRUE(ended.insert(corner.before).second);
  }
}

TEST(DistanceLattice, DistancesAreThoseOfTheShape) {
  std::vector<Outline> all = load_outlines(kDejaVuSans, 0, {'B', '@', 'i'});
  all.push_back(load_outlines(kLiberationSerif, 0, {'g'})[0]);
  all.push_back(outline({rectangle(0, 0, 100, 100),
                         rectangle(100, 100, 200, 200)}));  // touch in a point
  std::mt19937 random(3);
  for (const Outline& glyph : all) {
    Subject s(glyph);
    std::uniform_int_distribution<int> x(s.x0, s.x0 + s.width);
    std::uniform_int_distribution<int> y(s.y0, s.y0 + s.height);
    std::uniform_real_distribution<double> part(0, 1);
    const auto look_at = [&](int px, int py) {
      const double exact = s.shape.distance(px, py);
      const TruthSample first = s.truth.at(px, py);
      EXPECT_NEAR(first.distance_u, exact, 1e-4) << px << ' ' << py;
      EXPECT_EQ(s.truth.at(px, py).distance_u, first.distance_u);
      EXPECT_EQ(s.truth.at_point(px, py).distance_u, first.distance_u);
      EXPECT_EQ(s.truth.at_point(px, py).chain, first.chain);
    };
    for (int i = 0; i < 10000; ++i) {
      look_at(x(random), y(random));
      const double px = s.x0 + s.width * part(random);
      const double py = s.y0 + s.height * part(random);
      EXPECT_NEAR(s.truth.at_point(px, py).distance_u, s.shape.distance(px, py),
                  1e-4);
    }
    for (const int px : {s.x0, s.x0 + s.width}) {
      for (const int py : {s.y0, s.y0 + s.height}) {
        look_at(px, py);
      }
    }
  }
}

TEST(DistanceLattice, SidesOfASquareAreChains) {
  Subject s(outline({rectangle(0, 0, 300, 300)}));
  expect_consistent(s.truth);
  EXPECT_EQ(s.truth.chains().size(), 4u);
  EXPECT_EQ(s.truth.corners().size(), 4u);
  std::set<int> seen;
  for (const auto& [x, y] : {std::pair(150, -20), std::pair(320, 150),
                             std::pair(150, 320), std::pair(-20, 150)}) {
    const TruthSample& sample = s.truth.at(x, y);
    EXPECT_EQ(sample.distance_u, -20);
    EXPECT_EQ(sample.corner, -1);
    seen.insert(sample.chain);
  }
  EXPECT_EQ(seen.size(), 4u);
  // Inside, no corner is ever the nearest.
  for (int y = 1; y < 300; ++y) {
    for (int x = 1; x < 300; ++x) {
      ASSERT_EQ(s.truth.at(x, y).corner, -1) << x << ' ' << y;
    }
  }
}

TEST(DistanceLattice, CirclesHaveNoCorners) {
  for (const double radius : {1.0, 2.5, 20.0, 300.0}) {
    Subject s(outline({circle(10, 20, radius)}));
    expect_consistent(s.truth);
    EXPECT_EQ(s.truth.chains().size(), 1u) << radius;
    EXPECT_EQ(s.truth.corners().size(), 0u) << radius;
    EXPECT_EQ(s.truth.at(s.x0, s.y0).corner, -1);
    EXPECT_EQ(s.truth.at(s.x0, s.y0).chain, 0);
  }
}

TEST(DistanceLattice, LettersHaveTheCornersOneSees) {
  // All straight: each edge is a chain.
  Subject a(load_outlines(kDejaVuSans, 0, {'A'})[0]);
  expect_consistent(a.truth);
  EXPECT_EQ(a.truth.chains().size(), a.shape.edges().size());
  EXPECT_EQ(a.truth.corners().size(), 8u + 3u);
  // Two smooth contours.
  Subject o(load_outlines(kDejaVuSans, 0, {'o'})[0]);
  expect_consistent(o.truth);
  EXPECT_EQ(o.truth.chains().size(), 2u);
  EXPECT_EQ(o.truth.corners().size(), 0u);
  // Half circles end in straight lines.
  Subject d(load_outlines(kDejaVuSans, 0, {'D'})[0]);
  expect_consistent(d.truth);
  EXPECT_EQ(d.truth.chains().size(), 4u);
  EXPECT_EQ(d.truth.corners().size(), 4u);
}

TEST(DistanceLattice, ContoursThatTouchStayConsistent) {
  for (const std::vector<Contour>& contours :
       {std::vector<Contour>{rectangle(0, 0, 100, 100),
                             rectangle(100, 100, 200, 200)},
        std::vector<Contour>{rectangle(0, 0, 100, 100),
                             rectangle(100, 20, 200, 80)},
        std::vector<Contour>{rectangle(0, 0, 100, 100),
                             polygon({{100, 50}, {200, 0}, {200, 100}})},
        std::vector<Contour>{circle(0, 0, 50), circle(100, 0, 50)}}) {
    Subject s(outline(contours));
    expect_consistent(s.truth);
    for (int y = s.y0; y <= s.y0 + s.height; y += 3) {
      for (int x = s.x0; x <= s.x0 + s.width; x += 3) {
        ASSERT_NEAR(s.truth.at(x, y).distance_u, s.shape.distance(x, y), 1e-4);
      }
    }
  }
}

TEST(DistanceLattice, CornerSamplesLieInTheConeOfTheCorner) {
  Subject s(load_outlines(kDejaVuSans, 0, {'k'})[0]);
  expect_consistent(s.truth);
  const std::vector<Edge>& edges = s.shape.edges();
  int seen = 0;
  for (int y = s.y0; y <= s.y0 + s.height; y += 2) {
    for (int x = s.x0; x <= s.x0 + s.width; x += 2) {
      const TruthSample& sample = s.truth.at(x, y);
      if (sample.corner < 0) {
        continue;
      }
      ++seen;
      const Corner& corner =
          s.truth.corners()[static_cast<size_t>(sample.corner)];
      const double dx = x - corner.at.x;
      const double dy = y - corner.at.y;
      ASSERT_NEAR(std::hypot(dx, dy), std::fabs(sample.distance_u), 1e-4);
      EXPECT_TRUE(sample.chain == corner.before ||
                  sample.chain == corner.after);
      const BorderChain& before =
          s.truth.chains()[static_cast<size_t>(corner.before)];
      const BorderChain& after =
          s.truth.chains()[static_cast<size_t>(corner.after)];
      const Edge& out = edges[after.first_edge];
      EXPECT_LE(dx * (out.b.x - out.a.x) + dy * (out.b.y - out.a.y), 1e-6);
      // 'k' is all straight: a chain is an edge.
      ASSERT_EQ(before.edge_count, 1u);
      const Edge& in = edges[before.first_edge];
      EXPECT_GE(dx * (in.b.x - in.a.x) + dy * (in.b.y - in.a.y), -1e-6);
    }
  }
  EXPECT_GT(seen, 1000);
}

}  // namespace
}  // namespace test
}  // namespace gen
}  // namespace inkcell
