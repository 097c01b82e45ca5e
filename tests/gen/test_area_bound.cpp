// Bounds of areas against pixels at all positions.
#include <gtest/gtest.h>

#include "judge/area_bound.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "glyph_outlines.hpp"
#include "inkcell/painter.hpp"
#include "judge/canvas.hpp"
#include "judge/moved_area.hpp"
#include "judge/outline_glyph.hpp"
#include "judge/true_pictures.hpp"
#include "rom/outline_font.hpp"
#include "rom/rom_font.hpp"

namespace inkcell::gen::test {
namespace {

constexpr double kUnit = TruePictures::kUnit;

// The picture of each position is asked for once.
std::vector<int16_t> areas_of(const Shape& shape,
                              const PictureSetting& setting,
                              const Rect& pixels) {
  const auto count = static_cast<size_t>(pixels.x1 - pixels.x0) *
                     static_cast<size_t>(pixels.y1 - pixels.y0);
  if (shape.empty()) {
    return std::vector<int16_t>(count);
  }
  TruePictures pictures(shape, Measure::area);
  const int16_t* const first = pictures.next(setting, pixels);
  return {first, first + count};
}

Rect pixels_around(const Shape& a, const Shape& b, const PictureSetting& at) {
  const Rect p = at.pixels_of(a.box(), 1.5);
  const Rect q = at.pixels_of(b.box(), 1.5);
  return {std::min(p.x0, q.x0), std::min(p.y0, q.y0), std::max(p.x1, q.x1),
          std::max(p.y1, q.y1)};
}

template <typename Look>
void for_positions(int px, int step, const Look& look) {
  for (int y = 0; y < 64; y += step) {
    for (int x = 0; x < 64; x += step) {
      look(PictureSetting{px, x, y});
    }
  }
}

// The largest difference of a pixel at any position in 1/64 px. [1/255]
double most_of(const Shape& source, const Shape& drawn, int px) {
  int most = 0;
  for_positions(px, 1, [&](const PictureSetting& at) {
    const Rect pixels = pixels_around(source, drawn, at);
    const std::vector<int16_t> a = areas_of(source, at, pixels);
    const std::vector<int16_t> b = areas_of(drawn, at, pixels);
    for (size_t i = 0; i < a.size(); ++i) {
      most = std::max(most, std::abs(a[i] - b[i]));
    }
  });
  return most / kUnit;
}

double bound_of(const Shape& source, const Shape& drawn, int px) {
  std::vector<MovedPixel> beyond;
  return 255 *
         MovedArea(source, drawn).worst_pixel(px, {{}}, 1, {}, beyond).share;
}

Contour random_polygon(std::mt19937& random) {
  std::uniform_real_distribution<double> at(0, 90);
  std::vector<Point> corners;
  for (int i = 0; i < 6; ++i) {
    corners.push_back({at(random), at(random)});
  }
  return polygon(corners);
}

TEST(MovedArea, NoPixelIsBeyondTheBound) {
  const Outline square = outline({rectangle(20, 30, 80, 75)});
  std::vector<std::pair<Outline, Outline>> pairs = {
      {square, square},
      {square, outline({rectangle(20, 30, 83, 75)})},
      // A stroke as wide as a pixel of 64 px, thicker at both sides.
      {outline({rectangle(30, 0, 46, 90)}),
       outline({rectangle(29, 0, 47, 90)})},
      // One that is moved: gains here, loses there.
      {outline({rectangle(30, 0, 34, 90)}),
       outline({rectangle(31, 0, 35, 90)})},
      // A hole, a speck, nothing.
      {square, outline({rectangle(20, 30, 80, 75), rectangle(50, 40, 44, 44)})},
      {square, outline({rectangle(20, 30, 80, 75), rectangle(90, 90, 94, 95)})},
      {square, outline({})},
      {outline({circle(45, 45, 40)}), outline({circle(45.3, 44.6, 40.4)})},
  };
  std::mt19937 random(3);
  for (int i = 0; i < 6; ++i) {
    pairs.emplace_back(outline({random_polygon(random)}),
                       outline({random_polygon(random)}));
  }
  for (size_t i = 0; i < pairs.size(); ++i) {
    SCOPED_TRACE(i);
    const Shape source(pairs[i].first);
    const Shape drawn(pairs[i].second);
    for (const int px : {9, 37, 64}) {
      const double most = most_of(source, drawn, px);
      const double bound = bound_of(source, drawn, px);
      EXPECT_LE(most, bound + TruePictures::kBound / kUnit) << px;
      EXPECT_GE(most * 1.1 + 0.6, std::min(bound, 255.0)) << px;
    }
  }
}

TEST(MovedArea, NamesThePixels) {
  const Shape source(outline({rectangle(0, 0, 600, 600)}));
  const Shape drawn(outline({rectangle(0, 0, 600, 604)}));
  std::vector<MovedPixel> beyond;
  const MovedPixel worst =
      MovedArea(source, drawn).worst_pixel(64, {{}}, 0.1, {}, beyond);
  EXPECT_NEAR(worst.share, 0.25, 0.02);
  EXPECT_NEAR(worst.centre_u.y, 602, 10);
  EXPECT_GT(beyond.size(), 30u);
  for (const MovedPixel& pixel : beyond) {
    EXPECT_GT(pixel.share, 0.1);
    EXPECT_LE(pixel.share, worst.share);
  }
  const MovedPixel known = {0.3, {}};
  EXPECT_EQ(
      MovedArea(source, drawn).worst_pixel(64, {{}}, 1, known, beyond).share,
      0.3);
}

// A glyph in a font, drawn with the device's code.
struct Drawn {
  explicit Drawn(const Outline& source) : shape(source) {
    const Box& box = shape.box();
    GlyphMetrics metrics;
    metrics.x_min = static_cast<int16_t>(std::floor(box.x0));
    metrics.y_min = static_cast<int16_t>(std::floor(box.y0));
    metrics.x_max = static_cast<int16_t>(std::ceil(box.x1));
    metrics.y_max = static_cast<int16_t>(std::ceil(box.y1));
    Target target;
    target.coding = Coding::outline;
    const RefitOptions refit = refit_options(target, 1024, 1024, false);
    glyph = refit_glyph(source, shape, metrics, refit, LoopOptions());
    RomContent content;
    content.metrics.units_per_em = 1024;
    content.options = target;
    content.outlines.grid_shift = refit.grid_shift;
    content.glyphs.resize(2);
    content.glyphs[1].outline = glyph.outline;
    content.glyphs[1].metrics = metrics;
    encode_outlines_widely(content);
    PartBytes parts;
    bytes = write_rom_font(content, parts);
    EXPECT_EQ(Font::open({bytes.data(), bytes.size()}, font), Status::ok);
  }

  // The worst pixel of some positions, every `step`th 64th of a pixel.
  double worst(int px, int step) const {
    double most = 0;
    TruePictures pictures(shape, Measure::area);
    for_positions(px, step, [&](const PictureSetting& at) {
      const Rect pixels = at.pixels_of(shape.box(), 1.5);
      const int16_t* truth = pictures.next(at, pixels);
      Canvas canvas(pixels);
      const Style style(Q26_6::from_int(px), kFilterArea);
      inkcell::Painter(canvas.sink())
          .glyph(font, style,
                 {Q26_6::from_raw(at.phase_x), Q26_6::from_raw(at.phase_y)}, 1);
      for (int y = pixels.y0; y < pixels.y1; ++y) {
        for (int x = pixels.x0; x < pixels.x1; ++x) {
          most = std::max(most, std::fabs(canvas.at(x, y) - *truth++ / kUnit));
        }
      }
    });
    return most;
  }

  Shape shape;
  RefittedGlyph glyph;
  std::vector<uint8_t> bytes;
  Font font;
};

// The positions of the loop are eight of these.
TEST(AreaBound, HoldsAtAllPositions) {
  for (const char* file : {kDejaVuSans, kLiberationSerif}) {
    for (const Outline& source : load_outlines(file, 0, {'g', '}', '2'})) {
      const Drawn drawn(source);
      const double bound = drawn.glyph.errors.promised.worst;
      EXPECT_LE(bound, 16);
      double worst = 0;
      for (const int px : {11, 40, 57, 64}) {
        worst = std::max(worst, drawn.worst(px, 3));
      }
      EXPECT_LE(worst, bound);
      EXPECT_GT(worst, bound / 3);
    }
  }
}

// An outline that is wrong by a known area, a stroke of 16 u that lacks 2 u.
TEST(AreaBound, TellsOfAKnownError) {
  const Shape source(outline({rectangle(100, 0, 116, 700)}));
  MinimalOutline thin;
  thin.contours.push_back({{{100, 0, PointKind::corner},
                            {114, 0, PointKind::corner},
                            {114, 700, PointKind::corner},
                            {100, 700, PointKind::corner}}});
  RefitOptions refit;
  refit.units_per_em = 1024;
  const LoopResult result = bound_areas(source, thin, refit, LoopOptions());
  // 2 u of a pixel of 16 u.
  EXPECT_NEAR(result.worst, 255.0 * 2 / 16 + kAreaRounding, 1.5);
  EXPECT_EQ(result.worst_pixel.px, 64);
  EXPECT_NEAR(result.worst_pixel.x_u, 115, 10);
  ASSERT_FALSE(result.misses.empty());
  EXPECT_EQ(result.miss_count, result.misses.size());
  EXPECT_EQ(result.misses.front().error, result.worst);
  EXPECT_GT(result.misses.back().error, 16);
  // Right, it has roundings only.
  thin.contours[0].points[1].x = thin.contours[0].points[2].x = 116;
  EXPECT_EQ(bound_areas(source, thin, refit, LoopOptions()).worst,
            kAreaRounding);
}

TEST(AreaBound, OutlinesThatVanishAreAnError) {
  const Shape source(outline({rectangle(100, 0, 200, 700)}));
  EXPECT_EQ(bound_areas(source, {}, RefitOptions(), LoopOptions()).worst, 255);
}

}  // namespace
}  // namespace inkcell::gen::test
