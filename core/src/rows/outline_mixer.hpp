// How effects draw glyphs of outlines.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text_style.hpp"
#include "rows/band.hpp"

namespace inkcell {
namespace detail {

struct OutlinePainter;

// How the bands of a glyph are painted.
struct OutlinePlan {
  const OutlinePainter* painter = nullptr;
  // How far distances are good, outside and inside. [px]
  int32_t outside_q8 = 0;
  int32_t inside_q8 = 0;
  // How far from the ink a pixel's centre may show something. [px]
  int32_t shown_q8 = 0;
  // Samples a pixel, 1 or 3: columns of a band and rows. Only areas have 3.
  uint8_t columns = 1;
  uint8_t rows = 1;
  // Samples around the pixels that are drawn.
  uint8_t margin_x = 0;
  uint8_t margin_y = 0;

  // For the ramp of a filter.
  void widen(const Filter& filter) noexcept {
    outside_q8 = max(outside_q8, (-filter.outside_q10 >> 2) + 1);
    inside_q8 = max(inside_q8, (filter.inside_q10 >> 2) + 1);
  }

  // Samples before the first pixel of a band, from a multiple of 4 on: one of
  // them at least.
  int32_t columns_before(int32_t x0) const noexcept {
    return ((x0 * columns - margin_x - 1) & 3) + 1 + margin_x;
  }
  // Of a band of pixels, from there on. [samples]
  int32_t width_of(int32_t column, const Rect& pixels) const noexcept {
    return column + (pixels.x1 - pixels.x0) * columns + margin_x;
  }
};

// A band that is painted, and the pixels that it is for.
struct PaintedBand {
  Band band;
  Rect pixels;
  int32_t column;  // of the first sample of the first pixel
  int32_t row;
  const TextStyle* style;
  const Sink* sink;
};

// Makes coverage of painted bands and hands it to sinks. Linked with the
// painter that names it.
struct OutlineMixer {
  const OutlinePainter* painter;
  // Changes the plan that the style's filter asks for.
  void (*plan)(const TextStyle& style, OutlinePlan& plan) noexcept;
  void (*mix)(const PaintedBand& painted) noexcept;
};

}  // namespace detail
}  // namespace inkcell
