// Mixers that make one coverage of a pixel and those around it.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "rows/band.hpp"
#include "rows/source.hpp"

namespace inkcell::detail {

// Of mixers that read up to two pixels away.
inline void plan_neighbours(const Effect&,
                            const Style&,
                            BandPlan& plan) noexcept {
  plan.margin_x = 2;
  plan.margin_y = 2;
}

// Hands the coverage of each pixel to the sink; `cover` makes it of the pixel's
// byte in the band, which stays as it is.
template <typename Cover>
void mix_rows(const GlyphBand& band, const Cover& cover) noexcept {
  const Rect& pixels = band.pixels();
  for (int32_t y = pixels.y0; y != pixels.y1; ++y) {
    const uint8_t* at = band.row(y);
    for (int32_t x = pixels.x0; x < pixels.x1; x += kMaxSpan) {
      // Words of pixels, as emit_row() takes them.
      alignas(4) uint8_t words[kMaxSpan + 4];
      uint8_t* const coverage = words + (x & 3);
      const int32_t count = min(kMaxSpan, pixels.x1 - x);
      for (int32_t i = 0; i != count; ++i) {
        coverage[i] = cover(at++);
      }
      emit_row(band.sink(), x, y, coverage, count);
    }
  }
}

}  // namespace inkcell::detail
