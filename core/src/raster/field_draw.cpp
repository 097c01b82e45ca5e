// Upright cells of primitives, band by band, and distances at any point.
#include "raster/field_draw.hpp"

#include "base/math.hpp"
#include "cells/cell_access.hpp"
#include "place/position.hpp"
#include "raster/field_band.hpp"

namespace inkcell {
namespace detail {
namespace {

// Whether words at any address are as fast as others, as port/pixel has it.
#if defined(__ARM_FEATURE_UNALIGNED) || defined(__x86_64__)
constexpr bool kWordsAnywhere = true;
#else
constexpr bool kWordsAnywhere = false;
#endif

// Rows of a band, whose first point is that of the first pixel.
__attribute__((noinline)) void draw_band(FieldBand& band,
                                         const Rect& pixels,
                                         const Sink& sink) noexcept {
  const int32_t rows = pixels.y1 - pixels.y0;
  int32_t count;
  for (int32_t x = pixels.x0; x < pixels.x1; x += count) {
    FieldBand::Pixels lines;
    // Coverage of an x that is a multiple of 4 begins a word, so that sinks
    // of 8 bits can copy words.
    const int32_t first = kWordsAnywhere ? 0 : x & 3;
    count = min(pixels.x1 - x, FieldBand::kColumns - first);
    uint8_t* const line = lines.row(0) + first;
    lines.clear(rows);
    if (band.cover(count, rows, line)) {
      for (int32_t row = 0; row < rows; ++row) {
        sink.coverage(sink.context, x, pixels.y0 + row,
                      line + row * FieldBand::kColumns, count);
      }
    }
    band.go_right(count);
  }
}

}  // namespace

void draw_fields(const GlyphField& field,
                 const TextStyle& style,
                 const Placed& placed,
                 const Sink& sink) noexcept {
  Upright upright = place_upright(field, style, placed, sink.window);
  if (is_empty(upright.pixels)) {
    return;
  }
  FieldBand band(field, style);
  Rect pixels = upright.pixels;
  const int32_t end = pixels.y1;
  for (; pixels.y0 < end; pixels.y0 = pixels.y1) {
    pixels.y1 = pixels.y0 + FieldBand::rows_of(end - pixels.y0);
    band.go_to(upright.at);
    draw_band(band, pixels, sink);
    upright.go_down(style, pixels.y1 - pixels.y0);
  }
}

int32_t fields_distance_q10(const GlyphField& field,
                            const TextStyle& style,
                            const FieldPosition& at,
                            int32_t reach_q22) noexcept {
  const int32_t x_u = at.x_q16 >> 16;
  const int32_t y_u = at.y_q16 >> 16;
  Cell cell;
  if (in_grid(field, x_u, y_u)) {
    cell = locate_fields(field, x_u, y_u);
  }
  if (cell.field_count == 0) {
    return style.to_px_q10(cell.inside ? kSaturatedDistanceQ10
                                       : -kSaturatedDistanceQ10);
  }
  FieldTerms terms;
  set_up_terms(terms, field, cell, q8_of(at.x_q20), q8_of(at.y_q20),
               scale_of(style));
  return combine_q22(terms, style.bend_shift(), reach_q22) >> 12;
}

}  // namespace detail
}  // namespace inkcell
