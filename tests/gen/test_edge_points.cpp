// What a cell of primitives may show, and where it is looked at.
#include <gtest/gtest.h>

#include "edges/points.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "glyph_outlines.hpp"

namespace inkcell {
namespace gen {
namespace test {
namespace {

Target fields(double min_px, double max_px, double tolerance) {
  Target options;
  options.coding = Coding::edges;
  options.min_px = min_px;
  options.max_px = max_px;
  options.tolerance = tolerance;
  return options;
}

// `allow` gives the distances whose error is within the limit: one a little
// within passes, one a little beyond does not.
TEST(FieldPoints, AllowIsTheInverseOfTheError) {
  const Shape shape(outline({rectangle(0, 0, 300, 300)}));
  std::mt19937 random(4);
  std::uniform_real_distribution<double> part(0, 1);
  for (const Target& options :
       {fields(8, 64, 16), fields(12, 32, 8), fields(8, 128, 36),
        fields(4, 4, 100), fields(4, 1024, 1)}) {
    const Metric metric(options);
    const Grid grid = lay_grid(shape, options);
    const double limit = metric.limit();
    const PointSource source(shape, metric, grid, limit);
    const double span = 2.5 * metric.band_u();
    for (int i = 0; i < 20000; ++i) {
      const double scale = i % 2 == 0 ? span : 3 * metric.sharpest_u();
      const auto d = static_cast<float>(scale * (2 * part(random) - 1));
      float low = 0;
      float high = 0;
      source.allow(d, low, high);
      ASSERT_LE(low, d);
      ASSERT_GE(high, d);
      const double hair = 1e-3;
      const double least = std::max<double>(low, -3 * span);
      const double most = std::min<double>(high, 3 * span);
      const double a = least + (most - least) * part(random);
      ASSERT_LE(metric.error(d, a), limit + 0.01) << d << ' ' << a;
      ASSERT_LE(metric.error(d, least + hair * std::fabs(least)), limit + 0.01);
      ASSERT_LE(metric.error(d, most - hair * std::fabs(most)), limit + 0.01);
      if (std::isfinite(low)) {
        ASSERT_GT(metric.error(d, low - hair * (1 + std::fabs(low))), limit)
            << d << ' ' << low;
      }
      if (std::isfinite(high)) {
        ASSERT_GT(metric.error(d, high + hair * (1 + std::fabs(high))), limit)
            << d << ' ' << high;
      }
    }
  }
}

TEST(FieldPoints, BeyondTheBandAnythingSaturatedPasses) {
  const Shape shape(outline({rectangle(0, 0, 300, 300)}));
  const Target options = fields(8, 64, 16);
  const Metric metric(options);
  const PointSource source(shape, metric, lay_grid(shape, options), 16);
  float low = 0;
  float high = 0;
  const auto band = static_cast<float>(metric.band_u());
  source.allow(band + 1, low, high);
  EXPECT_TRUE(std::isinf(high));
  EXPECT_NEAR(low, band * (1 - 32.0 / 255), 0.01);
  source.allow(-band - 500, low, high);
  EXPECT_TRUE(std::isinf(low));
  EXPECT_NEAR(high, -band * (1 - 32.0 / 255), 0.01);
}

TEST(FieldPoints, LatticeCoversTheCellWithItsBorders) {
  const Shape shape(load_outlines(kDejaVuSans, 0, {'R'})[0]);
  const Target options = fields(8, 64, 16);
  PointSource source(shape, Metric(options), lay_grid(shape, options), 15);
  const Grid grid = source.grid();
  for (int log2 = 1; log2 <= 8; ++log2) {
    const int size = 1 << log2;
    const int x0 = grid.x0_u + 256;
    const int y0 = grid.y0_u + 256;
    const Points points = source.collect(x0, y0, log2);
    const auto has = [&](int x, int y) {
      for (size_t i = 0; i < points.size(); ++i) {
        if (points.x[i] == static_cast<float>(x) &&
            points.y[i] == static_cast<float>(y)) {
          return true;
        }
      }
      return false;
    };
    for (const int x : {0, size / 2, size}) {
      for (const int y : {0, size / 2, size}) {
        EXPECT_TRUE(has(x0 + x, y0 + y)) << log2;
      }
    }
    EXPECT_GE(points.size(), std::min<size_t>(17 * 17, 3u * 3u));
    size_t in_band = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      ASSERT_GE(points.x[i], static_cast<float>(x0));
      ASSERT_LE(points.x[i], static_cast<float>(x0 + size));
      ASSERT_GE(points.y[i], static_cast<float>(y0));
      ASSERT_LE(points.y[i], static_cast<float>(y0 + size));
      ASSERT_NEAR(points.d[i], shape.distance(points.x[i], points.y[i]), 1e-4);
      float low = 0;
      float high = 0;
      source.allow(points.d[i], low, high);
      ASSERT_EQ(points.low[i], low);
      ASSERT_EQ(points.high[i], high);
      ASSERT_EQ(points.in_band[i], std::fabs(points.d[i]) < 64);
      in_band += points.in_band[i] ? 1u : 0u;
      if (points.in_band[i] && points.corner[i] >= 0) {
        ASSERT_TRUE(std::binary_search(points.corners.begin(),
                                       points.corners.end(), points.corner[i]));
      }
    }
    EXPECT_EQ(points.in_band_count, in_band);
    EXPECT_TRUE(std::is_sorted(points.corners.begin(), points.corners.end()));
  }
}

TEST(FieldPoints, LatticeIsDenserNearTheEdge) {
  const Shape shape(outline({rectangle(3, 3, 253, 253)}));
  const Target options = fields(8, 64, 16);
  PointSource source(shape, Metric(options), lay_grid(shape, options), 15);
  const Points points = source.collect(0, 0, 8);
  size_t near = 0;
  size_t far = 0;
  for (const float d : points.d) {
    ++(std::fabs(d) < 8 ? near : far);
  }
  // Of 256 x 256 u, 1000 u of border and 8 u to either side.
  const double near_area = 1000 * 16.0;
  EXPECT_GT(static_cast<double>(near) / near_area,
            2 * static_cast<double>(far) / (65536 - near_area));
}

TEST(FieldPoints, ExtraPointsAreHeldToATighterLimit) {
  const Shape shape(outline({rectangle(0, 0, 300, 300)}));
  const Target options = fields(8, 64, 16);
  const Metric metric(options);
  PointSource source(shape, metric, lay_grid(shape, options), 15);
  const size_t before = source.collect(0, 0, 5).size();
  const size_t elsewhere = source.collect(64, 64, 5).size();
  source.add_extra({10.3, 4.7});
  const Points points = source.collect(0, 0, 5);
  ASSERT_EQ(points.size(), before + 1);
  EXPECT_EQ(source.collect(64, 64, 5).size(), elsewhere);
  const size_t last = points.size() - 1;
  EXPECT_FLOAT_EQ(points.x[last], 10.3f);
  EXPECT_FLOAT_EQ(points.y[last], 4.7f);
  EXPECT_FLOAT_EQ(points.d[last], 4.7f);
  float low = 0;
  float high = 0;
  source.allow(points.d[last], low, high);
  EXPECT_GT(points.low[last], low);
  EXPECT_LT(points.high[last], high);
  EXPECT_LT(points.low[last], points.d[last]);
  EXPECT_GT(points.high[last], points.d[last]);
  EXPECT_NEAR(metric.error(points.d[last], points.high[last]), 14.1, 0.01);
}

TEST(FieldPoints, SaturatedSquaresAreSeen) {
  const Shape shape(outline({rectangle(0, 0, 600, 600)}));
  const Target options = fields(8, 64, 16);
  PointSource source(shape, Metric(options), lay_grid(shape, options), 15);
  bool inside = false;
  EXPECT_TRUE(source.saturated(source.collect(200, 200, 7), inside));
  EXPECT_TRUE(inside);
  const Grid grid = source.grid();
  EXPECT_TRUE(source.saturated(source.collect(grid.x0_u, grid.y0_u, 4), inside))
      << "a corner of the grid is beyond the band";
  EXPECT_FALSE(inside);
  EXPECT_FALSE(source.saturated(source.collect(0, 0, 7), inside));
  EXPECT_FALSE(source.saturated(source.collect(20, 200, 4), inside));
}

// An error of the tolerance all along an edge of 256 u, 16 px at 64 px, on the
// ramp: 16 pixels of it. Lattices of all densities must agree.
TEST(FieldPoints, WeightsCountPixels) {
  const Target options = fields(8, 64, 16);
  const Shape shape(outline({rectangle(-600, -600, 5, 1200)}));
  const Metric metric(options);
  const Grid grid = lay_grid(shape, options);
  PointSource source(shape, metric, grid, metric.limit());
  const double error_u = 16.0 / 255 * 16;
  for (const int log2 : {5, 6, 7}) {
    const int size = 1 << log2;
    double pixels = 0;
    for (int y = 0; y < 256; y += size) {
      for (int x = -128; x < 128; x += size) {
        const Points points = source.collect(x, y, log2);
        ASSERT_EQ(points.weight.size(), points.size());
        for (size_t i = 0; i < points.size(); ++i) {
          if (std::fabs(points.d[i]) <= 8) {
            pixels += static_cast<double>(points.weight[i]) * error_u * error_u;
          }
        }
      }
    }
    EXPECT_NEAR(pixels, 16, 5) << log2;
  }
  // Where anything beyond the band passes, nothing counts.
  const Points far = source.collect(64, 0, 3);
  for (size_t i = 0; i < far.size(); ++i) {
    EXPECT_EQ(far.weight[i] > 0, std::isfinite(far.low[i])) << far.d[i];
  }
}

}  // namespace
}  // namespace test
}  // namespace gen
}  // namespace inkcell
