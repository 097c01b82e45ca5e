// Glyphs of fields as they are drawn.
#include <gtest/gtest.h>

#include "judge/edge_glyph.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <thread>

#include "edges/record.hpp"
#include "glyph_outlines.hpp"
#include "inkcell/render.hpp"

namespace inkcell {
namespace gen {
namespace test {
namespace {

EdgeGlyph build(const Shape& shape, int min_px, int max_px, double tolerance) {
  Target options;
  options.coding = Coding::edges;
  options.min_px = min_px;
  options.max_px = max_px;
  options.tolerance = tolerance;
  LoopOptions loop;
  loop.min_px = min_px;
  loop.max_px = max_px;
  loop.tolerance = tolerance;
  return build_edges(shape, options, loop);
}

GlyphField open(const EdgeGlyph& glyph) {
  GlyphField field;
  EXPECT_EQ(GlyphField::open({glyph.record.data(), glyph.record.size()}, field),
            Status::ok);
  return field;
}

// Largest error of pixels at random sizes and positions, none of which the
// encoder need have looked at. [1/255]
double worst_pixel(const Shape& shape,
                   const GlyphField& field,
                   int min_px,
                   int max_px) {
  std::mt19937 random(16);
  const auto between = [&](int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random);
  };
  double worst = 0;
  for (int i = 0; i < 3000; ++i) {
    const int size_q6 = between(64 * min_px, 64 * max_px);
    TextStyle style;
    EXPECT_EQ(TextStyle::make(Q26_6::from_raw(size_q6), kFilterText, style),
              Status::ok);
    const double scale = size_q6 / 64.0 / 1024;
    // Around the border: there pixels are neither empty nor full.
    const std::vector<Edge>& edges = shape.edges();
    const Point& near = edges[static_cast<size_t>(between(
                                  0, static_cast<int>(edges.size()) - 1))]
                            .a;
    const int left = between(0, 63);
    const int base = between(0, 63);
    const int x = static_cast<int>(std::floor(near.x * scale)) + between(-2, 2);
    const int y =
        static_cast<int>(std::floor(-near.y * scale)) + between(-2, 2);
    Q6_10 distance[1];
    distance_row(field, style,
                 inkcell::Point{Q26_6::from_raw(left), Q26_6::from_raw(base)},
                 x, y, distance);
    const double exact = shape.distance((x + 0.5 - left / 64.0) / scale,
                                        (base / 64.0 - y - 0.5) / scale);
    const double wanted = 255 * std::clamp(0.5 + exact * scale, 0.0, 1.0);
    worst = std::max(worst,
                     std::fabs(kFilterText.coverage(distance[0].raw) - wanted));
  }
  return worst;
}

void expect_good(const Outline& source,
                 int min_px,
                 int max_px,
                 double tolerance) {
  const Shape shape(source);
  const EdgeGlyph glyph = build(shape, min_px, max_px, tolerance);
  EXPECT_LE(glyph.errors.worst, tolerance);
  EXPECT_EQ(glyph.record, edge_record(glyph.tree));
  const double worst = worst_pixel(shape, open(glyph), min_px, max_px);
  EXPECT_LE(worst, tolerance);
  EXPECT_GT(worst, 0);
}

// The range in thirds, the tolerance in the rest.
class Ranges : public testing::TestWithParam<int> {};

TEST_P(Ranges, ToleranceHoldsAsDrawn) {
  const struct {
    const char* file;
    uint32_t letters[3];
  } faces[] = {{kDejaVuSans, {'%', 'e', 'a'}},
               {kLiberationSerif, {'g', 'R', '1'}},
               {kRoboto, {'&', 's', 'k'}}};
  const int ranges[][2] = {{12, 32}, {8, 64}, {8, 128}};
  const double tolerances[] = {36, 16, 8};
  const int range = GetParam() / 3;
  const int step = GetParam() % 3;
  const auto& face = faces[(range + step) % 3];
  expect_good(load_outlines(face.file, 0, {face.letters[range]})[0],
              ranges[range][0], ranges[range][1], tolerances[step]);
}

INSTANTIATE_TEST_SUITE_P(EdgeGlyph, Ranges, testing::Range(0, 9));

// Strokes of 12, 4 and 1 u: a fifth to a sixtieth of a pixel at 16 px.
TEST(EdgeGlyph, ThinStrokesKeepTheTolerance) {
  expect_good(outline({rectangle(0, 0, 12, 700)}), 8, 64, 16);
  expect_good(outline({rectangle(0, 0, 700, 4)}), 8, 64, 16);
  expect_good(outline({rectangle(3.3, 0, 4.3, 300)}), 8, 64, 16);
  expect_good(outline({polygon({{0, 0}, {8, 0}, {408, 600}, {400, 600}})}), 8,
              64, 16);
}

TEST(EdgeGlyph, TinyDotsKeepTheTolerance) {
  for (const double radius : {1.0, 3.0, 8.0}) {
    SCOPED_TRACE(radius);
    expect_good(outline({circle(333.3, 77.7, radius)}), 8, 64, 16);
  }
  expect_good(outline({rectangle(0, 0, 900, 200), circle(411.3, 196, 9)}), 8,
              64, 16);
}

// A rectangle whose corners are quarters of circles.
Contour rounded(double x0, double y0, double x1, double y1, double radius) {
  const double k = 0.5522847498 * radius;
  const Point centres[] = {{x1 - radius, y0 + radius},
                           {x1 - radius, y1 - radius},
                           {x0 + radius, y1 - radius},
                           {x0 + radius, y0 + radius}};
  const Point ways[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  Contour contour;
  for (int i = 0; i < 4; ++i) {
    const Point& c = centres[i];
    const Point& from = ways[i];
    const Point& to = ways[(i + 1) % 4];
    const Point start = {c.x + radius * from.x, c.y + radius * from.y};
    const Point end = {c.x + radius * to.x, c.y + radius * to.y};
    if (i > 0) {
      Segment side;
      side.p[0] = contour.segments.back().p[3];
      side.p[1] = start;
      contour.segments.push_back(side);
    }
    Segment bend;
    bend.kind = Segment::Kind::cubic;
    bend.p[0] = start;
    bend.p[1] = {start.x + k * to.x, start.y + k * to.y};
    bend.p[2] = {end.x + k * from.x, end.y + k * from.y};
    bend.p[3] = end;
    contour.segments.push_back(bend);
  }
  return contour;
}

TEST(EdgeGlyph, RoundedCornersKeepTheTolerance) {
  for (const double radius : {2.0, 6.0, 15.0, 40.0}) {
    SCOPED_TRACE(radius);
    expect_good(outline({rounded(0, 0, 500, 300, radius)}), 8, 64, 16);
  }
}

TEST(EdgeGlyph, OverlappingContoursKeepTheTolerance) {
  expect_good(outline({rectangle(0, 0, 400, 120),
                       rectangle(100, -200, 230, 400), circle(300, 60, 140)}),
              8, 64, 16);
}

// Of 12, 4 and 1 degrees, and of 90 to the inside.
TEST(EdgeGlyph, SharpCornersKeepTheTolerance) {
  for (const double half : {63.0, 20.0, 5.0}) {
    SCOPED_TRACE(half);
    expect_good(outline({polygon({{0, 0}, {600, -half}, {600, half}})}), 8, 64,
                16);
  }
  expect_good(
      outline({polygon(
          {{0, 0}, {500, 0}, {500, 100}, {100, 100}, {100, 500}, {0, 500}})}),
      8, 64, 16);
}

// Teeth as narrow as half the smallest square: what comes out says how wrong it
// is.
TEST(EdgeGlyph, StatesItsErrorWhereTheToleranceIsMissed) {
  Outline comb = outline({rectangle(0, 0, 40, 10)});
  for (int i = 0; i < 20; ++i) {
    comb.contours.push_back(rectangle(2 * i, 10, 2 * i + 1, 30));
  }
  const Shape shape(comb);
  const EdgeGlyph glyph = build(shape, 1024, 1024, 2);
  EXPECT_GT(glyph.errors.worst, 2);
  EXPECT_FALSE(glyph.errors.misses.empty());
  LoopOptions loop;
  loop.min_px = loop.max_px = 1024;
  EXPECT_EQ(ClosedLoop(shape, loop).draw_and_compare(open(glyph)).worst,
            glyph.errors.worst);
}

// As many tiles as a glyph of fields may have in a row.
TEST(EdgeGlyph, WideGlyphsFit) {
  const Shape shape(outline({rectangle(-1850, 0, 1850, 60)}));
  const EdgeGlyph glyph = build(shape, 8, 64, 16);
  EXPECT_EQ(glyph.tree.grid.tiles_x, 15);
  EXPECT_LE(glyph.errors.worst, 16);
  EXPECT_LT(glyph.record.size(), 800u);
}

TEST(EdgeGlyph, RefusesWhatReachesTooFar) {
  for (const auto& [x0, x1] : {std::pair(-300, 1990), std::pair(-1990, 300)}) {
    const Shape shape(outline({rectangle(x0, 0, x1, 60)}));
    try {
      build(shape, 8, 64, 16);
      ADD_FAILURE() << x0;
    } catch (const GeometryError& error) {
      EXPECT_EQ(error.kind(), GeometryError::Kind::too_large);
    }
  }
}

TEST(EdgeGlyph, ResultIsTheSameInEveryThread) {
  const Shape shape(load_outlines(kRoboto, 0, {'r'})[0]);
  const EdgeGlyph expected = build(shape, 12, 24, 16);
  std::vector<EdgeGlyph> found(8);
  std::vector<std::thread> threads;
  for (EdgeGlyph& glyph : found) {
    threads.emplace_back([&] { glyph = build(shape, 12, 24, 16); });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (const EdgeGlyph& glyph : found) {
    EXPECT_EQ(glyph.record, expected.record);
    EXPECT_EQ(glyph.errors.worst, expected.errors.worst);
  }
}

// Hundreds of contours: it ends, well or with a reason.
TEST(EdgeGlyph, ManyContoursTakeBoundedTime) {
  Outline gravel;
  for (int i = 0; i < 16 * 16; ++i) {
    const double x = i % 16 * 24;
    const double y = i / 16 * 24;
    gravel.contours.push_back(rectangle(x, y, x + 8, y + 8));
  }
  const auto begin = std::chrono::steady_clock::now();
  expect_good(gravel, 12, 16, 36);
  EXPECT_LT(std::chrono::steady_clock::now() - begin,
            std::chrono::seconds(100));
}

}  // namespace
}  // namespace test
}  // namespace gen
}  // namespace inkcell
