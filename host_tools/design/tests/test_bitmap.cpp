// Bitmaps: files, edges, noise.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bitmap/bitmap.hpp"
#include "bitmap/edge_walk.hpp"
#include "bitmap/scan.hpp"
#include "fixtures.hpp"
#include "image.hpp"
#include "model/error.hpp"
#include "shape/shape.hpp"

namespace inkcell::design::test {
namespace {

constexpr int kSide = 200;

// A disc of 60 px about (100, 100) with a hole of 20 px.
Bitmap ring() {
  Bitmap bitmap;
  bitmap.width = bitmap.height = kSide;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double r = std::hypot(x + 0.5 - 100, y + 0.5 - 100);
      bitmap.ink.push_back(r < 60 && r > 20 ? 255 : 0);
    }
  }
  return bitmap;
}

MasterOptions options_for_ring() {
  MasterOptions options;
  options.place.px_per_em = 1024;
  options.place.origin_y = kSide;
  return options;
}

TEST(Master, ARingIsTwoCirclesOfFewCubics) {
  const gen::Outline outline = outline_of(ring(), options_for_ring());
  ASSERT_EQ(outline.contours.size(), 2u);
  const gen::Shape shape(outline);
  for (int i = 0; i < 100; ++i) {
    const double a = i * 0.0628;
    EXPECT_LT(std::fabs(shape.distance(100 + 60 * std::cos(a),
                                       100 + 60 * std::sin(a))),
              0.5);
    EXPECT_LT(std::fabs(shape.distance(100 + 20 * std::cos(a),
                                       100 + 20 * std::sin(a))),
              0.5);
  }
  EXPECT_GT(shape.distance(100, 140), 15);
  EXPECT_LT(shape.distance(100, 100), -15);
}

// One pixel in a thousand is wrong.
TEST(Master, SaltDoesNoHarm) {
  Bitmap bitmap = ring();
  std::mt19937 random(9);
  for (int i = 0; i < kSide * kSide / 1000; ++i) {
    uint8_t& pixel = bitmap.ink[random() % bitmap.ink.size()];
    pixel = static_cast<uint8_t>(255 - pixel);
  }
  const gen::Outline outline = outline_of(bitmap, options_for_ring());
  EXPECT_EQ(outline.contours.size(), 2u);
}

// A bar on a baseline that falls by 0.1 becomes level.
TEST(Master, ASlantingScanIsTurnedUpright) {
  constexpr double kEm_px = 160;
  const double c = std::cos(0.1);
  const double s = std::sin(0.1);
  Bitmap bitmap;
  bitmap.width = bitmap.height = kSide;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double along = c * (x + 0.5 - 40) + s * (y + 0.5 - 140);
      const double above = s * (x + 0.5 - 40) - c * (y + 0.5 - 140);
      bitmap.ink.push_back(
          along > 10 && along < 90 && above > 10 && above < 60 ? 255 : 0);
    }
  }
  MasterOptions options;
  options.place = place_between({40, 140}, {40 + kEm_px * c, 140 + kEm_px * s});
  const gen::Shape shape(outline_of(bitmap, options));
  const double px = 1024 / kEm_px;
  EXPECT_NEAR(shape.box().x0, 10 * px, px / 2);
  EXPECT_NEAR(shape.box().y0, 10 * px, px / 2);
  EXPECT_NEAR(shape.box().x1, 90 * px, px / 2);
  EXPECT_NEAR(shape.box().y1, 60 * px, px / 2);
  EXPECT_NEAR(shape.distance(50 * px, 35 * px), 25 * px, px / 2);
  EXPECT_THROW(place_between({4, 4}, {8, 4}), Error);
}

TEST(Bitmap, ReadsPng) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "a.png";
  tools::Image image(3, 1);
  image.pixels = {255, 128, 0};
  tools::write_image(file, image);
  EXPECT_EQ(read_bitmap(file).ink, (std::vector<uint8_t>{0, 127, 255}));
  write_text(file, "no bitmap at all");
  EXPECT_THROW(read_bitmap(file), Error);
}

TEST(Bitmap, OtsuDividesInkAndPaper) {
  Bitmap bitmap;
  bitmap.width = 100;
  bitmap.height = 1;
  for (int i = 0; i < 100; ++i) {
    bitmap.ink.push_back(
        static_cast<uint8_t>(i < 70 ? 20 + i % 9 : 190 + i % 7));
  }
  const int threshold = otsu_threshold(bitmap);
  EXPECT_GT(threshold, 28);
  EXPECT_LE(threshold, 190);
  make_bilevel(bitmap, threshold);
  EXPECT_TRUE(bitmap.is_bilevel());
  EXPECT_EQ(bitmap.ink[69], 0);
  EXPECT_EQ(bitmap.ink[70], 255);
}

// Upright bars on paper, in light that falls from left to right.
Bitmap uneven_scan(int width, int height, double fall) {
  Bitmap bitmap;
  bitmap.width = width;
  bitmap.height = height;
  for (int i = 0; i < width * height; ++i) {
    const int x = i % width;
    const double light = 1 - fall * x / width;
    const bool is_ink = x % 40 >= 30;
    bitmap.ink.push_back(static_cast<uint8_t>(
        255 - static_cast<int>(light * (is_ink ? 100 : 230))));
  }
  return bitmap;
}

TEST(Bitmap, LevelsTheLightOfAScan) {
  Bitmap bitmap = uneven_scan(400, 60, 0.7);
  // Paper on the right is darker than ink on the left: no single threshold
  // works.
  ASSERT_GT(bitmap.at(389, 30), bitmap.at(35, 30));
  level_light(bitmap);
  for (int x = 0; x < bitmap.width; ++x) {
    const bool is_ink = x % 40 >= 30;
    EXPECT_NEAR(bitmap.at(x, 30), is_ink ? 144 : 0, 8) << x;
  }
}

TEST(Bitmap, ScansWithoutPaperStayAsTheyAre) {
  for (const int side : {1, 2, 9}) {
    Bitmap bitmap = uneven_scan(side, side, 0.6);
    const std::vector<uint8_t> ink = bitmap.ink;
    level_light(bitmap);
    EXPECT_EQ(bitmap.ink, ink);
  }
  Bitmap black = uneven_scan(40, 40, 0);
  std::fill(black.ink.begin(), black.ink.end(), uint8_t{255});
  level_light(black);
  EXPECT_EQ(black.ink, std::vector<uint8_t>(1600, 255));
}

TEST(Bitmap, SmallScansAreEnlargedWithTheirPlace) {
  Bitmap bitmap = uneven_scan(80, 20, 0);
  MasterOptions options;
  options.place.px_per_em = 300;
  options.place.origin_x = 10;
  options.place.origin_y = 20;
  divide_scan(bitmap, options);
  EXPECT_TRUE(bitmap.is_bilevel());
  EXPECT_EQ(bitmap.width, 320);
  EXPECT_EQ(bitmap.height, 80);
  EXPECT_EQ(options.place.px_per_em, 1200);
  EXPECT_EQ(options.place.origin_x, 40);
  EXPECT_EQ(options.place.origin_y, 80);
  EXPECT_EQ(options.least_area_px, MasterOptions().least_area_px * 16);
  EXPECT_EQ(bitmap.at(4 * 30 - 3, 40), 0);
  EXPECT_EQ(bitmap.at(4 * 30 + 3, 40), 255);
}

}  // namespace
}  // namespace inkcell::design::test
