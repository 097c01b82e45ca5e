// Near pictures of shapes against the exact distance of each pixel.
#include <gtest/gtest.h>

#include "judge/true_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "glyph_outlines.hpp"

namespace inkcell::gen {
namespace test {
namespace {

constexpr double kMargin_px = 1.5;

struct Picture {
  Rect pixels;
  std::vector<int16_t> coverage;
};

Picture next(TruePictures& pictures,
             const Shape& shape,
             const PictureSetting& setting) {
  const Rect pixels = setting.pixels_of(shape.box(), kMargin_px);
  const int16_t* const first = pictures.next(setting, pixels);
  const auto count = static_cast<size_t>(pixels.x1 - pixels.x0) *
                     static_cast<size_t>(pixels.y1 - pixels.y0);
  return {pixels, {first, first + count}};
}

// The largest error of a pixel, in TruePictures::kUnit.
int worst_of(const Shape& shape, const std::vector<PictureSetting>& settings) {
  TruePictures pictures(shape, Measure::distance);
  int worst = 0;
  for (const PictureSetting& setting : settings) {
    const Picture picture = next(pictures, shape, setting);
    auto at = picture.coverage.begin();
    for (int y = picture.pixels.y0; y < picture.pixels.y1; ++y) {
      for (int x = picture.pixels.x0; x < picture.pixels.x1; ++x) {
        const double distance_px =
            shape.distance(setting.x_u(x), setting.y_u(y)) / setting.u_per_px();
        const double exact =
            255 * TruePictures::kUnit * std::clamp(0.5 + distance_px, 0.0, 1.0);
        worst = std::max(worst,
                         static_cast<int>(std::ceil(std::fabs(*at++ - exact))));
      }
    }
  }
  return worst;
}

std::vector<PictureSetting> settings_of(const std::vector<int>& sizes) {
  std::vector<PictureSetting> settings;
  for (const int px : sizes) {
    settings.push_back({px, 0, 0});
    settings.push_back({px, 24, 57});
  }
  return settings;
}

TEST(TruePictures, AreNearTheExactDistance) {
  for (const char* font : {kDejaVuSans, kLiberationSerif, kRoboto}) {
    for (const Outline& glyph : load_outlines(
             font, 0, {'a', '%', '@', '.', 'S', 'i', '/', '-', 0xc6})) {
      EXPECT_LE(worst_of(Shape(glyph),
                         settings_of({4, 8, 9, 16, 17, 31, 33, 64, 100})),
                TruePictures::kBound);
    }
  }
}

TEST(TruePictures, AreNearTheExactDistanceInLargeSizes) {
  const Shape shape(load_outlines(kLiberationSerif, 0, {'g'}).front());
  EXPECT_LE(worst_of(shape, settings_of({300, 1024})), TruePictures::kBound);
}

// Slits and bars narrower than a pixel, and a speck.
TEST(TruePictures, HoldNarrowParts) {
  const Shape shape(
      outline({rectangle(0, 0, 400, 3), rectangle(0, 5, 400, 9),
               rectangle(50, 20, 51, 400), rectangle(300, 300, 303, 303),
               polygon({{100, 50}, {380, 280}, {101, 51.5}})}));
  EXPECT_LE(worst_of(shape, settings_of({8, 20, 64, 128})),
            TruePictures::kBound);
}

// The area of a pixel, by the lengths of many lines.
double area_of(const Shape& shape, double x_u, double y_u, double size_u) {
  constexpr int kLines = 400;
  std::vector<double> crossings;
  double sum = 0;
  for (int i = 0; i < kLines; ++i) {
    shape.crossings(y_u + (i + 0.5) / kLines * size_u - size_u / 2, crossings);
    for (size_t j = 0; j + 1 < crossings.size(); j += 2) {
      const double left = std::max(crossings[j], x_u - size_u / 2);
      const double right = std::min(crossings[j + 1], x_u + size_u / 2);
      sum += std::max(0.0, right - left) / (size_u * kLines);
    }
  }
  return sum;
}

TEST(TruePictures, AreNearTheExactArea) {
  for (const Outline& glyph :
       load_outlines(kLiberationSerif, 0, {'a', '%', '@', '.', 'S', '/'})) {
    const Shape shape(glyph);
    TruePictures pictures(shape, Measure::area);
    for (const PictureSetting& setting : settings_of({8, 17, 33, 64})) {
      const Picture picture = next(pictures, shape, setting);
      auto at = picture.coverage.begin();
      for (int y = picture.pixels.y0; y < picture.pixels.y1; ++y) {
        for (int x = picture.pixels.x0; x < picture.pixels.x1; ++x) {
          const double exact = 255 * TruePictures::kUnit *
                               area_of(shape, setting.x_u(x), setting.y_u(y),
                                       setting.u_per_px());
          // Lines may miss half of the distance between them.
          EXPECT_NEAR(*at++, exact, TruePictures::kBound + 2 * 255 * 128 / 800);
        }
      }
    }
  }
}

TEST(TruePictures, AreTheSameWhenAskedAgain) {
  const Shape shape(load_outlines(kRoboto, 0, {'&'}).front());
  const std::vector<PictureSetting> settings = settings_of({8, 40, 64, 12});
  TruePictures pictures(shape, Measure::area);
  std::vector<Picture> first;
  for (const PictureSetting& setting : settings) {
    first.push_back(next(pictures, shape, setting));
  }
  pictures.rewind();
  for (size_t i = 0; i < settings.size(); ++i) {
    EXPECT_EQ(next(pictures, shape, settings[i]).coverage, first[i].coverage);
  }
}

}  // namespace
}  // namespace test
}  // namespace inkcell::gen
