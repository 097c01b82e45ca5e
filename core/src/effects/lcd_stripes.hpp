// Sub-pixels, of outlines and of cells.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "inkcell/lcd.hpp"

namespace inkcell {
namespace detail {

// The mean of three to within a level, without a division.
inline uint8_t third(int32_t sum) noexcept {
  return static_cast<uint8_t>((sum * 171 + 85) >> 9);
}
inline uint8_t mean(int32_t a, int32_t b, int32_t c) noexcept {
  return third(a + b + c);
}

inline bool is_vertical(SubPixels order) noexcept {
  return order == SubPixels::rgb_vertical || order == SubPixels::bgr_vertical;
}

inline bool is_red_first(SubPixels order) noexcept {
  return order == SubPixels::rgb || order == SubPixels::rgb_vertical;
}

// Hands on pixels of three coverages, which may be changed.
__attribute__((noinline)) inline void hand_on(const Sink& sink,
                                              const LcdOptions& lcd,
                                              int32_t x,
                                              int32_t y,
                                              uint8_t* rgb,
                                              int32_t count) noexcept {
  const bool is_grey = sink.coverage_rgb == nullptr;
  if (is_grey || lcd.colour != 255) {
    for (int32_t i = 0; i < count; ++i) {
      uint8_t* const pixel = rgb + 3 * i;
      const int32_t grey = mean(pixel[0], pixel[1], pixel[2]);
      for (int32_t j = 0; j < 3; ++j) {
        pixel[j] =
            static_cast<uint8_t>(grey + (pixel[j] - grey) * lcd.colour / 255);
      }
    }
  }
  if (!is_grey) {
    sink.coverage_rgb(sink.context, x, y, rgb, count);
    return;
  }
  for (int32_t i = 0; i < count; ++i) {
    rgb[i] = mean(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
  }
  sink.coverage(sink.context, x, y, rgb, count);
}

struct GlyphJob;

// How stripes lie in a band. [bytes]
struct StripeSteps {
  int32_t before;  // from a pixel's first stripe to the one before it
  int32_t stripe;  // to the next one
  int32_t behind;  // to the first one that is not the pixel's
  int32_t pixel;   // to the next pixel's
  int32_t row;     // to that of the pixel below
};

// Makes channels of a band of stripes' coverages, each the mean of three, and
// hands them on. The first pixel lies at job.column and job.row.
void mix_stripes(const GlyphJob& job, const StripeSteps& steps) noexcept;

}  // namespace detail
}  // namespace inkcell
