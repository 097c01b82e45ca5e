#include "inkcell/render.hpp"

#include "cells/cell_access.hpp"
#include "cells/field_cell.hpp"
#include "place/position.hpp"
#include "raster/field_draw.hpp"
#include "raster/field_points.hpp"
#include "raster/field_turned.hpp"
#include "raster/plain.hpp"
#include "raster/samples_cells.hpp"
#include "sink/span_writer.hpp"

namespace inkcell {
namespace {

using detail::clamp;
using detail::FieldPosition;
using detail::has_fields;
using detail::kObjectOrder;
using detail::limits_of;
using detail::max;
using detail::min;
using detail::Placed;
using detail::position_of;
using detail::Range;
using detail::SlantedPoint;
using detail::SpanWriter;
using detail::Upright;
using detail::wrapped;

// What a row of a cell shows.
enum class Side : uint8_t { outside, inside, both };

Side side_of(const SamplesRow& row, const TextStyle& style) noexcept {
  const SamplesRow::Bounds bounds = row.bounds_q10();
  if (style.is_transparent(bounds.high)) {
    return Side::outside;
  }
  return style.is_opaque(bounds.low) ? Side::inside : Side::both;
}

// One row of upright text: y is constant in the glyph, so that a cell is set up
// once and then costs two products a pixel, and none where all of its row is
// saturated.
//
// Not inline, like the other loops: glyphs of fields need not pay for its
// stack.
//
// Invariant of the outer loop: `x` is the next pixel, at `x_q16` in the grid.
__attribute__((noinline)) void draw_upright_row(const GlyphField& field,
                                                const TextStyle& style,
                                                Range pixels,
                                                int32_t x_q16,
                                                int32_t y_q16,
                                                SpanWriter& writer) noexcept {
  const int32_t step = style.step_along_q16();
  int32_t x = pixels.begin;
  while (x < pixels.end) {
    const Cell cell = detail::locate_cell(field, x_q16 >> 16, y_q16 >> 16);
    const int32_t left_q16 = cell.x0_u * (1 << 16);
    const int32_t right_q16 = left_q16 + (int32_t{1} << (16 + cell.size_log2));
    Side side = cell.inside ? Side::inside : Side::outside;
    SamplesRow row;
    if (cell.samples != nullptr) {
      detail::set_up_row(row, cell.samples, cell.size_log2,
                         y_q16 - cell.y0_u * (1 << 16));
      side = side_of(row, style);
    }
    if (side == Side::both) {
      do {
        writer.put(x, style.coverage(row.distance_q10(x_q16 - left_q16)));
        ++x;
        x_q16 += step;
      } while (x < pixels.end && x_q16 < right_q16);
      continue;
    }
    const int32_t first = x;
    do {
      ++x;
      x_q16 += step;
    } while (x < pixels.end && x_q16 < right_q16);
    if (side == Side::inside) {
      writer.solid(first, x - first);
    } else {
      writer.flush();
    }
  }
}

// Pixels along one of the glyph's axes, counted the way it leads.
struct Line {
  Range pixels;
  int32_t origin_q10;  // [px]
  Range grid_u;
  Range ink_u;
  // Where the centres of the first and of the last pixel are. [u]
  int32_t first_q16;
  int32_t last_q16;
};

// Leaves of a window's pixels those whose centres lie in the limits. False:
// there are none.
inline bool place_line(const TextStyle& style, Line& line) noexcept {
  // What is as far from the ink as the filter reaches shows nothing. Cutoffs
  // within 4 px are 2^10 u at the most.
  constexpr int32_t kOneQ16 = 1 << 16;
  const int32_t reach_q16 = -64 * style.transparent_u_q10();
  const int32_t low_q16 = max(line.grid_u.begin * kOneQ16,
                              line.ink_u.begin * kOneQ16 - reach_q16 + 1);
  const int32_t high_q16 =
      min(line.grid_u.end * kOneQ16, line.ink_u.end * kOneQ16 + reach_q16);
  // The pixel at a place, or one of those beside it: steps that are rounded
  // down lead up to 1/4 px astray at the ends of the largest grid.
  const auto pixel_at = [&](int32_t place_u, int32_t origin_q10) noexcept {
    return (origin_q10 + ((place_u * style.size().raw) >> 6)) >> 10;
  };
  const int32_t origin_q10 = line.origin_q10;
  int32_t begin = max(line.pixels.begin, pixel_at(low_q16 >> 16, origin_q10));
  int32_t end =
      min(line.pixels.end, pixel_at((high_q16 >> 16) + 1, origin_q10) + 1);
  if (begin >= end) {
    return false;
  }
  // position_of, whose products stay below 2^31 here.
  const int32_t step = style.step_along_q16();
  int32_t first_q16 = detail::u_of_px(begin * 1024 + 512 - origin_q10, step);
  int32_t last_q16 = first_q16 + (end - begin - 1) * step;
  for (; last_q16 >= high_q16; last_q16 -= step) {
    --end;
  }
  for (; first_q16 < low_q16; first_q16 += step) {
    ++begin;
  }
  line.pixels = {begin, end};
  line.first_q16 = first_q16;
  line.last_q16 = last_q16;
  return begin < end;
}

// The centre of a pixel from the origin. [px, Q20]
uint32_t centre_q20(int32_t pixel, int32_t origin_q10) noexcept {
  return static_cast<uint32_t>(pixel * 1024 + 512 - origin_q10) * 1024 +
         detail::kHalfQ20;
}

// Row by row: cells of samples, and in pixel order cells of primitives.
__attribute__((always_inline)) inline void draw_rows(
    const GlyphField& field,
    const TextStyle& style,
    const Placed& placed,
    const Sink& sink) noexcept {
  Upright upright = detail::place_upright(field, style, placed, sink.window);
  const Rect& pixels = upright.pixels;
  SpanWriter writer(sink, pixels.y0);
  for (int32_t y = pixels.y0; y < pixels.y1; ++y) {
    const Range row = {pixels.x0, pixels.x1};
    if (!kObjectOrder && has_fields(field)) {
      SlantedPoint at = {
          static_cast<uint32_t>(upright.at.x_q16 - field.x0_u * (1 << 16)),
          static_cast<uint32_t>(upright.at.y_q16 - field.y0_u * (1 << 16)),
          upright.at.x_q20, upright.at.y_q20};
      detail::draw_points(field, style, nullptr, at, row, writer);
    } else {
      draw_upright_row(field, style, row, upright.at.x_q16, upright.at.y_q16,
                       writer);
    }
    writer.next_row();
    upright.go_down(style, 1);
  }
}

// Not inline: glyphs of fields need not pay for its stack.
__attribute__((noinline)) void draw_samples(const GlyphField& field,
                                            const TextStyle& style,
                                            const Placed& placed,
                                            const Sink& sink) noexcept {
  draw_rows(field, style, placed, sink);
}

// Cells of samples: object order wins from this size on.
constexpr Q26_6 kCellsFrom = Q26_6::from_int(48);

}  // namespace

void detail::draw_upright(const GlyphField& field,
                          const TextStyle& style,
                          const Placed& placed,
                          const Sink& sink) noexcept {
  if (!kObjectOrder) {
    draw_rows(field, style, placed, sink);
  } else if (has_fields(field)) {
    detail::draw_fields(field, style, placed, sink);
  } else if (style.size().raw >= kCellsFrom.raw) {
    detail::draw_samples_by_cells(field, style, placed, sink);
  } else {
    draw_samples(field, style, placed, sink);
  }
}

// Not inline: what it needs of the stack is free again when pixels are drawn.
__attribute__((noinline)) detail::Upright detail::place_upright(
    const GlyphField& field,
    const TextStyle& style,
    const Placed& placed,
    const Rect& window) noexcept {
  Upright upright;
  const InkBox& ink = field.ink;
  Line across;
  across.pixels = {window.x0, window.x1};
  across.origin_q10 = placed.x_q10;
  across.grid_u = {field.x0_u, field.x1_u()};
  across.ink_u = {ink.x0_u, ink.x1_u};
  if (!place_line(style, across)) {
    return upright;
  }
  // From below: rows are counted upwards, the one above the screen is 0.
  Line along;
  along.pixels = {-window.y1, -window.y0};
  along.origin_q10 = -placed.y_q10;
  along.grid_u = {field.y0_u, field.y1_u()};
  along.ink_u = {ink.y0_u, ink.y1_u};
  if (!place_line(style, along)) {
    return upright;
  }
  upright.pixels = {across.pixels.begin, -along.pixels.end, across.pixels.end,
                    -along.pixels.begin};
  upright.at = {across.first_q16, along.last_q16,
                centre_q20(across.pixels.begin, across.origin_q10),
                centre_q20(along.pixels.end - 1, along.origin_q10)};
  return upright;
}

void detail::draw_plain(const GlyphField& field,
                        const TextStyle& style,
                        const FinePoint& origin,
                        const Sink& sink) noexcept {
  Placed placed;
  if (!style.is_upright()) {
    style.slanted()(field, style, nullptr, origin, sink);
  } else if (placed.set(origin)) {
    draw_upright(field, style, placed, sink);
  }
}

// Not inline: other ways to draw need not pay for its stack.
__attribute__((noinline)) void detail::draw_painted(const GlyphField& field,
                                                    const TextStyle& style,
                                                    const Placed& placed,
                                                    const Sink& sink) {
  const CellEffect painter =
      style.effect().cells != nullptr ? style.effect().cells : style.slanted();
  if (painter == nullptr) {
    draw_upright(field, style, placed, sink);
  } else {
    painter(field, style, style.effect().options, placed.origin(), sink);
  }
}

Rect detail::box_of(const GlyphField& field,
                    const TextStyle& style,
                    const Placed& placed) noexcept {
  if (field.tiles_x == 0 || field.tiles_y == 0) {
    return {};
  }
  const Rect limits = limits_of(field, style);
  const int32_t more = style.effect().reach_px;
  const Rect box = style.is_upright()
                       ? upright_box(limits, style, placed)
                       : style.slant().box(limits, style, placed);
  return {box.x0 - more, box.y0 - more, box.x1 + more, box.y1 + more};
}

Rect field_box(const GlyphField& field,
               const TextStyle& style,
               FinePoint origin) noexcept {
  // Origins that are too far to be seen remain so.
  constexpr int64_t kLimit = Placed::kLimit;
  const Placed placed = {
      static_cast<int32_t>(clamp(origin.x_q10, -kLimit, kLimit - 1)),
      static_cast<int32_t>(clamp(origin.y_q10, -kLimit, kLimit - 1))};
  return detail::box_of(field, style, placed);
}

void draw_field(const GlyphField& field,
                const TextStyle& style,
                FinePoint origin,
                const Sink& sink) noexcept {
  Placed placed;
  if (placed.set(origin)) {
    detail::draw_near(field, style, placed, sink);
  }
}

void distance_row(const GlyphField& field,
                  const TextStyle& style,
                  FinePoint origin,
                  int32_t x,
                  int32_t y,
                  Span<Q6_10> out) noexcept {
  for (Q6_10& distance : out) {
    const FieldPosition at = position_of(style, origin, x, y);
    int32_t in_px = 0;
    if (style.is_stretched()) {
      in_px =
          has_fields(field)
              ? detail::stretched_fields_q10(field, style, at, detail::kNoReach)
              : detail::stretched_samples_q10(field, style, at);
    } else if (has_fields(field)) {
      in_px = detail::fields_distance_q10(field, style, at, detail::kNoReach);
    } else {
      in_px = style.to_px_q10(
          detail::samples_distance_q10(field, at.x_q16, at.y_q16));
    }
    in_px = static_cast<int32_t>(clamp(in_px, INT16_MIN, INT16_MAX));
    distance.raw = static_cast<int16_t>(in_px);
    ++x;
  }
}

}  // namespace inkcell
