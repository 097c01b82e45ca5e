// The closed loop against pixels drawn and measured one by one.
#include <gtest/gtest.h>

#include "judge/closed_loop.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "glyph_outlines.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/format/rom.hpp"
#include "judge/canvas.hpp"
#include "shape/distance_map.hpp"

namespace inkcell::gen {
namespace test {
namespace {

constexpr int kTile_u = 16;

// Means are taken with near pictures, whose errors are a tenth of their bound
// in the mean. [1/255]
constexpr double kMeanBound = 0.1 * TruePictures::kBound / TruePictures::kUnit;

// A glyph record of cells of nine samples, 16 u wide, saturated 112 u away from
// the edge.
class Field {
 public:
  using Distance = std::function<double(double x_u, double y_u)>;

  Field(int x0_u, int y0_u, int tiles_x, int tiles_y, const Distance& distance)
      : distance_(distance) {
    std::vector<uint8_t> references;
    std::vector<uint8_t> cells;
    for (int y = 0; y < tiles_y; ++y) {
      for (int x = 0; x < tiles_x; ++x) {
        put(reference_of(x0_u + x * kTile_u, y0_u + y * kTile_u, cells),
            references);
      }
    }
    bytes_ = {format::glyph::kTypeSamples, 4};
    put(x0_u, bytes_);
    put(y0_u, bytes_);
    bytes_.push_back(static_cast<uint8_t>(tiles_x));
    bytes_.push_back(static_cast<uint8_t>(tiles_y));
    put(0, bytes_);
    put(static_cast<int>(cells.size() / format::samples::kBytes), bytes_);
    bytes_.insert(bytes_.end(), references.begin(), references.end());
    bytes_.insert(bytes_.end(), cells.begin(), cells.end());
    EXPECT_EQ(GlyphField::open({bytes_.data(), bytes_.size()}, field_),
              Status::ok);
  }

  const GlyphField& view() const { return field_; }

 private:
  static void put(int value, std::vector<uint8_t>& out) {
    out.push_back(static_cast<uint8_t>(value & 0xff));
    out.push_back(static_cast<uint8_t>((value >> 8) & 0xff));
  }

  int reference_of(int x_u, int y_u, std::vector<uint8_t>& cells) const {
    const double half = kTile_u / 2.0;
    const double centre = distance_(x_u + half, y_u + half);
    if (std::fabs(centre) > 112) {
      return centre > 0 ? format::glyph::kInside : format::glyph::kOutside;
    }
    const size_t number = cells.size() / format::samples::kBytes;
    put(static_cast<int>(std::lround(centre * 64)), cells);
    for (const int i : {0, 1, 2, 3, 5, 6, 7, 8}) {
      const double offset =
          distance_(x_u + i % 3 * half, y_u + i / 3 * half) - centre;
      cells.push_back(
          static_cast<uint8_t>(std::lround(offset * 128 / kTile_u) & 0xff));
    }
    return format::glyph::kCellFlag | static_cast<int>(number);
  }

  Distance distance_;
  std::vector<uint8_t> bytes_;
  GlyphField field_;
};

// The field of a shape, with a margin.
Field field_of(const Shape& shape) {
  const auto tile = [](double u) {
    return static_cast<int>(std::floor(u / kTile_u));
  };
  const Box& box = shape.box();
  const int x0 = tile(box.x0) - 8;
  const int y0 = tile(box.y0) - 8;
  return Field(x0 * kTile_u, y0 * kTile_u, tile(box.x1) + 9 - x0,
               tile(box.y1) + 9 - y0,
               [&](double x, double y) { return shape.distance(x, y); });
}

// The loop without shortcuts.
struct Plain {
  double worst = 0;
  double mean = 0;
  size_t misses = 0;
  // How far pixels are from the filter of the field's distance. [1/255]
  double rounded = 0;

  Plain(const GlyphField& field,
        const Shape& shape,
        const LoopOptions& options,
        int px,
        const std::vector<std::pair<int, int>>& phases) {
    const Style style(Q26_6::from_int(px), kFilterText);
    const double scale = px / 1024.0;
    const Box& box = shape.box();
    double sum = 0;
    size_t count = 0;
    for (const auto& [dx, dy] : phases) {
      const Point origin = {dx / 64.0, dy / 64.0};
      const inkcell::Point at = {Q26_6::from_raw(dx), Q26_6::from_raw(dy)};
      for (int y = -200; y < 100; ++y) {
        for (int x = -100; x < 200; ++x) {
          const double x_px = x + 0.5 - origin.x;
          const double y_px = origin.y - y - 0.5;
          Canvas pixel(Rect{x, y, x + 1, y + 1});
          draw_field(field, style, at, pixel.sink());
          const double drawn = pixel.at(x, y);
          Q6_10 distance[1];
          distance_row(field, style, at, x, y, distance);
          rounded = std::max(
              rounded,
              std::fabs(drawn - kFilterText.coverage(distance[0].raw)));
          const double exact = shape.distance(x_px / scale, y_px / scale);
          const double error = std::fabs(
              drawn - 255 * std::clamp(0.5 + exact * scale, 0.0, 1.0));
          worst = std::max(worst, error);
          misses += error > options.tolerance ? 1 : 0;
          if (x_px > box.x0 * scale - 1.5 && x_px < box.x1 * scale + 1.5 &&
              y_px > box.y0 * scale - 1.5 && y_px < box.y1 * scale + 1.5) {
            sum += error;
            ++count;
          }
        }
      }
    }
    mean = sum / static_cast<double>(count);
  }
};

TEST(ClosedLoop, AgreesWithThePlainWay) {
  const std::vector<Outline> glyphs =
      load_outlines(kDejaVuSans, 0, {'a', '%', '@', '.'});
  for (const Outline& glyph : glyphs) {
    const Shape shape(glyph);
    const Field field = field_of(shape);
    for (const int px : {8, 11, 23, 64}) {
      SCOPED_TRACE(px);
      LoopOptions options;
      options.min_px = options.max_px = px;
      options.phases = 2;
      options.tolerance = 3;
      options.max_misses = 1000000;
      const LoopResult result =
          ClosedLoop(shape, options).draw_and_compare(field.view());
      const Plain plain(field.view(), shape, options, px, {{0, 0}, {32, 32}});
      EXPECT_GT(plain.worst, 0);
      // Bands hold 127 steps of the filter's reach.
      EXPECT_LE(plain.rounded, 1);
      ASSERT_EQ(result.sizes.size(), 1u);
      EXPECT_EQ(result.sizes[0].px, px);
      EXPECT_NEAR(result.worst, plain.worst, 1e-6);
      EXPECT_NEAR(result.worst_mean, plain.mean, kMeanBound);
      EXPECT_EQ(result.miss_count, plain.misses);
      EXPECT_EQ(result.misses.size(), plain.misses);
    }
  }
}

TEST(ClosedLoop, GivesTheWorstOfAllSizesAndPhases) {
  const Shape shape(load_outlines(kLiberationSerif, 0, {'g'}).front());
  const Field field = field_of(shape);
  LoopOptions options;
  options.min_px = 10;
  options.max_px = 13;
  const LoopResult all =
      ClosedLoop(shape, options).draw_and_compare(field.view());
  ASSERT_EQ(all.sizes.size(), 4u);
  double worst = 0;
  double mean = 0;
  for (int i = 0; i < 4; ++i) {
    const SizeError& size = all.sizes[static_cast<size_t>(i)];
    EXPECT_EQ(size.px, 10 + i);
    LoopOptions one = options;
    one.min_px = one.max_px = 10 + i;
    const LoopResult alone =
        ClosedLoop(shape, one).draw_and_compare(field.view());
    EXPECT_EQ(size.worst, alone.worst);
    EXPECT_EQ(size.mean, alone.worst_mean);
    one.phases = 1;
    EXPECT_LE(ClosedLoop(shape, one).draw_and_compare(field.view()).worst,
              size.worst);
    worst = std::max(worst, size.worst);
    mean = std::max(mean, size.mean);
  }
  EXPECT_EQ(all.worst, worst);
  EXPECT_EQ(all.worst_mean, mean);
}

TEST(ClosedLoop, SaysTheSameWhenAskedAgain) {
  const Shape shape(load_outlines(kRoboto, 0, {'&'}).front());
  const Field field = field_of(shape);
  const Field other(0, 0, 1, 1, [](double, double) { return 200.0; });
  LoopOptions options;
  options.max_px = 12;
  ClosedLoop loop(shape, options);
  const LoopResult first = loop.draw_and_compare(field.view());
  EXPECT_GT(loop.draw_and_compare(other.view()).worst, 200);
  const LoopResult again = loop.draw_and_compare(field.view());
  EXPECT_EQ(again.worst, first.worst);
  EXPECT_EQ(again.worst_mean, first.worst_mean);
}

TEST(ClosedLoop, MissesLieWhereTheFieldIsWrong) {
  // A notch in the right side that the field lacks.
  const Shape shape(outline({polygon({{0, 0},
                                      {400, 0},
                                      {400, 180},
                                      {360, 200},
                                      {400, 220},
                                      {400, 400},
                                      {0, 400}})}));
  const Shape plain(outline({rectangle(0, 0, 400, 400)}));
  const Field field = field_of(plain);
  LoopOptions options;
  options.min_px = 32;
  options.max_px = 34;
  options.max_misses = 5;
  ClosedLoop loop(shape, options);
  const LoopResult result = loop.draw_and_compare(field.view());
  EXPECT_GT(result.miss_count, 5u);
  ASSERT_EQ(result.misses.size(), 5u);
  EXPECT_EQ(result.misses.front().error, result.worst);
  for (const LoopMiss& miss : result.misses) {
    EXPECT_LE(miss.error, result.misses.front().error);
    EXPECT_GT(miss.error, options.tolerance);
    EXPECT_GE(miss.px, 32);
    EXPECT_LE(miss.px, 34);
    EXPECT_LT(std::hypot(miss.x_u - 390, miss.y_u - 200), 50);
    // The rectangle is drawn there.
    const double scale = miss.px / 1024.0;
    const auto coverage = [&](const Shape& s) {
      return 255 *
             std::clamp(0.5 + s.distance(miss.x_u, miss.y_u) * scale, 0.0, 1.0);
    };
    EXPECT_NEAR(miss.error, coverage(plain) - coverage(shape), 1.5);
  }
  EXPECT_TRUE(std::is_sorted(
      result.misses.begin(), result.misses.end(),
      [](const LoopMiss& a, const LoopMiss& b) { return a.error > b.error; }));
}

TEST(ClosedLoop, SeesInkFarFromTheShape) {
  const Shape shape(outline({rectangle(0, 0, 100, 100)}));
  const Shape both(
      outline({rectangle(0, 0, 100, 100), rectangle(800, 600, 900, 700)}));
  LoopOptions options;
  options.min_px = options.max_px = 40;
  ClosedLoop loop(shape, options);
  const LoopResult result = loop.draw_and_compare(field_of(both).view());
  EXPECT_EQ(result.worst, 255);
  ASSERT_FALSE(result.misses.empty());
  EXPECT_NEAR(result.misses.front().x_u, 850, 50);
  EXPECT_NEAR(result.misses.front().y_u, 650, 50);
  // But the mean is that of the box.
  EXPECT_EQ(result.worst_mean,
            loop.draw_and_compare(field_of(shape).view()).worst_mean);
}

TEST(ClosedLoop, SeesThatInkIsMissing) {
  const Shape shape(outline({rectangle(0, 0, 200, 200)}));
  LoopOptions options;
  options.min_px = options.max_px = 32;
  const LoopResult result =
      ClosedLoop(shape, options).draw_and_compare(GlyphField());
  EXPECT_EQ(result.worst, 255);
  EXPECT_GT(result.worst_mean, 70);
}

TEST(ClosedLoop, GlyphWithoutInkHasNoErrorButInk) {
  const Shape empty{Outline()};
  const LoopOptions options;
  ClosedLoop loop(empty, options);
  const LoopResult nothing = loop.draw_and_compare(GlyphField());
  EXPECT_EQ(nothing.sizes.size(), 57u);
  EXPECT_EQ(nothing.worst, 0);
  EXPECT_EQ(nothing.worst_mean, 0);
  const Field ink(0, 0, 40, 40, [](double, double) { return 200.0; });
  EXPECT_EQ(loop.draw_and_compare(ink.view()).worst, 255);
}

// A pixel of a picture, if its window has it.
void put(const Sink& sink, int x, int y, uint8_t ink) {
  const Rect& window = sink.window;
  if (x >= window.x0 && x < window.x1 && y >= window.y0 && y < window.y1) {
    sink.coverage(sink.context, x, y, &ink, 1);
  }
}

// A glyph drawn rightly at 16 px, but for an error of some pixels. [1/255]
LoopGlyph wrong_glyph(
    const Shape& shape,
    std::function<double(int x, int y, inkcell::Point origin)> error) {
  return {
      [](const Style&, inkcell::Point) { return Rect{}; },
      [&shape, error](const Style&, inkcell::Point origin, const Sink& sink) {
        for (int y = sink.window.y0; y < sink.window.y1; ++y) {
          for (int x = sink.window.x0; x < sink.window.x1; ++x) {
            const double distance_px =
                shape.distance((x + 0.5 - origin.x.raw / 64.0) * 64,
                               (origin.y.raw / 64.0 - y - 0.5) * 64) /
                64;
            double ink = 255 * std::clamp(0.5 + distance_px, 0.0, 1.0);
            ink += (ink < 128 ? 1 : -1) * error(x, y, origin);
            const auto byte = static_cast<uint8_t>(std::lround(ink));
            sink.coverage(sink.context, x, y, &byte, 1);
          }
        }
      }};
}

// A pixel that is worst, by 20/255, at a position between those that the
// loop draws, and better the farther the glyph's origin is from there.
double error_between(inkcell::Point origin) {
  const int away =
      std::max(std::abs(origin.x.raw - 11), std::abs(origin.y.raw - 5));
  return std::max(0.0, 20 - 0.6 * away);
}

LoopOptions options_of_16_px() {
  LoopOptions options;
  options.min_px = options.max_px = 16;
  options.tolerance = 15.5;
  return options;
}

TEST(ClosedLoop, FollowsPixelsToOtherPositions) {
  const Shape shape(load_outlines(kDejaVuSans, 0, {'o'}).front());
  const LoopGlyph glyph =
      wrong_glyph(shape, [](int x, int y, inkcell::Point origin) {
        return x == 4 && y == -5 ? error_between(origin) : 0;
      });
  int drawn = 0;
  const LoopGlyph counted = {
      glyph.box,
      [&](const Style& style, inkcell::Point origin, const Sink& sink) {
        ++drawn;
        glyph.draw(style, origin, sink);
      }};
  const LoopResult found =
      ClosedLoop(shape, options_of_16_px()).draw_and_compare(counted);
  EXPECT_NEAR(found.worst, 20, 1);
  ASSERT_EQ(found.miss_count, 1u);
  EXPECT_NEAR(found.misses[0].x_u, (4.5 - 11 / 64.0) * 64, 1e-9);
  EXPECT_NEAR(found.misses[0].y_u, (5 / 64.0 + 4.5) * 64, 1e-9);
  EXPECT_EQ(found.misses[0].px, 16);
  EXPECT_LT(drawn, 8 + 3 * 3 * 8 + 1);
}

// Another place of the same size is worse where the loop draws.
TEST(ClosedLoop, FollowsTheWorstPixelOfEachPlace) {
  const Shape shape(load_outlines(kDejaVuSans, 0, {'o'}).front());
  const LoopGlyph glyph =
      wrong_glyph(shape, [](int x, int y, inkcell::Point origin) {
        return x == 4 && y == -5   ? error_between(origin)
               : x == 7 && y == -5 ? 14.5
                                   : 0;
      });
  const LoopResult found =
      ClosedLoop(shape, options_of_16_px()).draw_and_compare(glyph);
  EXPECT_NEAR(found.worst, 20, 1);
  EXPECT_GT(found.miss_count, 0u);
}

// A pixel far from a square, where no ink belongs: within the tolerance at the
// position that the loop draws, beyond it at others.
TEST(ClosedLoop, FollowsPixelsFarFromTheShape) {
  const Shape shape(outline({rectangle(0, 0, 256, 256)}));
  LoopOptions options;
  options.min_px = options.max_px = 16;
  options.phases = 1;
  const Rect pixels[] = {
      {-40, -2, -39, -1}, {44, -2, 45, -1}, {2, -44, 3, -43}, {2, 40, 3, 41}};
  for (const Rect& wrong : pixels) {
    const LoopGlyph glyph = {
        [&](const Style&, inkcell::Point) { return wrong; },
        [&](const Style&, inkcell::Point origin, const Sink& sink) {
          if (origin.x.raw == 0 && origin.y.raw == 0) {
            for (int y = -4; y < 0; ++y) {
              for (int x = 0; x < 4; ++x) {
                put(sink, x, y, 255);
              }
            }
          }
          put(sink, wrong.x0, wrong.y0, origin.x.raw == 0 ? 14 : 18);
        }};
    const LoopResult found = ClosedLoop(shape, options).draw_and_compare(glyph);
    EXPECT_EQ(found.worst, 18);
    ASSERT_EQ(found.miss_count, 1u);
    EXPECT_NEAR(found.misses[0].x_u, (wrong.x0 + 0.5) * 64, 4);
    EXPECT_NEAR(found.misses[0].y_u, (-wrong.y0 - 0.5) * 64, 4);
  }
}

TEST(ClosedLoop, SizesAreAllThatMatter) {
  const std::vector<int> usual = loop_sizes(8, 64);
  ASSERT_EQ(usual.size(), 57u);
  for (size_t i = 0; i < usual.size(); ++i) {
    EXPECT_EQ(usual[i], 8 + static_cast<int>(i));
  }
  EXPECT_EQ(loop_sizes(1024, 1024), std::vector<int>{1024});
  const std::vector<int> many = loop_sizes(4, 1000);
  EXPECT_EQ(many.front(), 4);
  EXPECT_EQ(many.back(), 1000);
  for (size_t i = 1; i < many.size(); ++i) {
    EXPECT_GT(many[i], many[i - 1]);
    EXPECT_LE(many[i], many[i - 1] + std::max(1, many[i - 1] / 64));
  }
}

TEST(ClosedLoop, OnePhaseServesLargeSizes) {
  const Shape shape(outline({rectangle(0, 0, 200, 200)}));
  const Field field = field_of(shape);
  LoopOptions options;
  options.min_px = options.max_px = 512;
  const LoopResult all =
      ClosedLoop(shape, options).draw_and_compare(field.view());
  options.phases = 1;
  const LoopResult one =
      ClosedLoop(shape, options).draw_and_compare(field.view());
  EXPECT_GT(all.worst_mean, 0);
  EXPECT_EQ(all.worst_mean, one.worst_mean);
}

TEST(ClosedLoop, RefusesSizesThatTheDeviceCannotDraw) {
  const Shape shape(outline({rectangle(0, 0, 200, 200)}));
  LoopOptions options;
  options.min_px = 3;
  EXPECT_THROW(ClosedLoop(shape, options).draw_and_compare(GlyphField()),
               std::invalid_argument);
}

TEST(DistanceMap, HoldsTheDistancesOfTheShape) {
  for (const uint32_t letter : {U'S', U'@', U'i'}) {
    const Shape shape(load_outlines(kLiberationSerif, 0, {letter}).front());
    const Box& box = shape.box();
    constexpr double kMargin = 192;
    DistanceMap map(shape, kMargin);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(box.x0 - kMargin,
                                             box.x1 + kMargin);
    std::uniform_real_distribution<double> y(box.y0 - kMargin,
                                             box.y1 + kMargin);
    const auto look_at = [&](double x_u, double y_u) {
      EXPECT_NEAR(map.distance(x_u, y_u), shape.distance(x_u, y_u), 1e-9);
    };
    for (int i = 0; i < 20000; ++i) {
      look_at(x(random), y(random));
    }
    for (const double x_u : {box.x0 - kMargin, box.x1 + kMargin}) {
      for (const double y_u : {box.y0 - kMargin, box.y1 + kMargin}) {
        EXPECT_TRUE(map.holds(x_u, y_u));
        look_at(x_u, y_u);
      }
    }
    // The map ends at whole tiles and blocks.
    constexpr double kBeyond = kMargin + 64;
    for (const auto& [x_u, y_u] : {std::pair(box.x0 - kBeyond, box.y0),
                                   std::pair(box.x1 + kBeyond, box.y0),
                                   std::pair(box.x0, box.y0 - kBeyond),
                                   std::pair(box.x0, box.y1 + kBeyond)}) {
      EXPECT_FALSE(map.holds(x_u, y_u));
    }
  }
}

}  // namespace
}  // namespace test
}  // namespace inkcell::gen
