#include "inkcell/render.hpp"

#include "cell_access.hpp"
#include "field_cell.hpp"
#include "field_draw.hpp"
#include "field_turned.hpp"
#include "inkcell/row_map.hpp"
#include "plain.hpp"
#include "position.hpp"
#include "samples_cells.hpp"
#include "span_writer.hpp"

namespace inkcell {
namespace {

using detail::clamp;
using detail::FieldPosition;
using detail::has_fields;
using detail::limits_of;
using detail::position_of;
using detail::Range;
using detail::SpanWriter;
using detail::Upright;

// What a row of a cell shows.
enum class Side : uint8_t { outside, inside, both };

Side side_of(const SamplesRow& row, const Brush& brush) noexcept {
  const SamplesRow::Bounds bounds = row.bounds_q10();
  if (brush.is_transparent(bounds.high)) {
    return Side::outside;
  }
  return brush.is_opaque(bounds.low) ? Side::inside : Side::both;
}

// Clamps to what int32_t pixels and their positions can bear.
int32_t to_pixel(int64_t px_q10) noexcept {
  constexpr int64_t kLimit = int64_t{1} << 30;
  return static_cast<int32_t>(clamp(px_q10 >> 10, -kLimit, kLimit));
}

// From `low` to `high`, in px. [Q10]
struct Extent {
  int64_t low;
  int64_t high;
};

// From one place in the glyph to another, in px, along an axis of the screen.
Extent extent_of(Extent place_q10, Fixed<int32_t, 30> factor) noexcept {
  const int64_t low = (place_q10.low * factor.raw) >> 30;
  const int64_t high = (place_q10.high * factor.raw) >> 30;
  return low < high ? Extent{low, high} : Extent{high, low};
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
                                                const Brush& brush,
                                                Range pixels,
                                                int32_t x_q16,
                                                int32_t y_q16,
                                                SpanWriter& writer) noexcept {
  const int32_t step = brush.step_along_q16();
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
      side = side_of(row, brush);
    }
    if (side == Side::both) {
      do {
        writer.put(x, brush.coverage(row.distance_q10(x_q16 - left_q16)));
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

// Not inline: what it needs of the stack is free again when pixels are drawn.
__attribute__((noinline)) Upright upright_of(const GlyphField& field,
                                             const Brush& brush,
                                             const FinePoint& origin,
                                             const RowMap* rows,
                                             const Rect& box) noexcept {
  const int32_t step = brush.step_along_q16();
  // The box has few others.
  const Rect limits = limits_of(field, brush);
  Upright upright = {box, position_of(brush, origin, box.x0, box.y0), rows,
                     limits.y0, limits.y1};
  Rect& pixels = upright.pixels;
  FieldPosition& at = upright.at;
  while (at.x_q16 < limits.x0 * (1 << 16)) {
    ++pixels.x0;
    at.x_q16 += step;
    at.x_q20 += 1 << 20;
  }
  int32_t right_q16 = at.x_q16 + (pixels.x1 - pixels.x0 - 1) * step;
  while (pixels.x0 < pixels.x1 && right_q16 >= limits.x1 * (1 << 16)) {
    --pixels.x1;
    right_q16 -= step;
  }
  if (rows != nullptr) {
    return upright;
  }
  while (at.y_q16 >= limits.y1 * (1 << 16)) {
    ++pixels.y0;
    upright.next_row(brush);
  }
  int32_t low_q16 = at.y_q16 - (pixels.y1 - pixels.y0 - 1) * step;
  while (pixels.y0 < pixels.y1 && low_q16 < limits.y0 * (1 << 16)) {
    --pixels.y1;
    low_q16 += step;
  }
  return upright;
}

__attribute__((noinline)) void draw_samples(const GlyphField& field,
                                            const Brush& brush,
                                            Upright& upright,
                                            const Sink& sink) noexcept {
  const Rect& pixels = upright.pixels;
  SpanWriter writer(sink, pixels.y0);
  for (int32_t y = pixels.y0; y < pixels.y1; ++y) {
    FieldPosition at;
    if (upright.place_row(brush, at)) {
      draw_upright_row(field, brush, {pixels.x0, pixels.x1}, at.x_q16, at.y_q16,
                       writer);
    }
    writer.next_row();
    upright.next_row(brush);
  }
}

// Cells of samples: object order wins from this size on.
constexpr Q26_6 kCellsFrom = Q26_6::from_int(48);

// Not inline: other ways to draw need not pay for its stack.
__attribute__((noinline)) void draw_upright(const GlyphField& field,
                                            const Brush& brush,
                                            const FinePoint& origin,
                                            const RowMap* rows,
                                            const Sink& sink) noexcept {
  const Rect box = intersect(field_box(field, brush, origin), sink.window);
  if (is_empty(box)) {
    return;
  }
  Upright upright = upright_of(field, brush, origin, rows, box);
  if (is_empty(upright.pixels)) {
    return;
  }
  if (has_fields(field)) {
    detail::draw_fields(field, brush, upright, sink);
  } else if (rows == nullptr && brush.size().raw >= kCellsFrom.raw) {
    detail::draw_samples_by_cells(field, brush, upright, sink);
  } else {
    draw_samples(field, brush, upright, sink);
  }
}

void draw_placed(const GlyphField& field,
                 const Brush& brush,
                 const FinePoint& origin,
                 const RowMap* rows,
                 const Sink& sink) noexcept {
  if (brush.painter() != nullptr) {
    brush.painter()(field, brush, brush.painter_options(), origin, rows, sink);
  } else {
    detail::draw_plain(field, brush, origin, rows, sink);
  }
}

// Not inline: only fitted glyphs pay for the map on the stack.
__attribute__((noinline)) void draw_fitted(const GlyphField& field,
                                           const Brush& brush,
                                           FinePoint origin,
                                           const Sink& sink) noexcept {
  RowMap rows;
  brush.fitter()(field, brush, brush.fitter_options(), origin, rows);
  draw_placed(field, brush, origin, &rows, sink);
}

}  // namespace

void detail::draw_plain(const GlyphField& field,
                        const Brush& brush,
                        const FinePoint& origin,
                        const RowMap* rows,
                        const Sink& sink) noexcept {
  if (brush.is_upright()) {
    draw_upright(field, brush, origin, rows, sink);
  } else {
    brush.slanted()(field, brush, nullptr, origin, nullptr, sink);
  }
}

Rect field_box(const GlyphField& field,
               const Brush& brush,
               FinePoint origin) noexcept {
  if (field.tiles_x == 0 || field.tiles_y == 0) {
    return {};
  }
  const Rect limits = limits_of(field, brush);
  const int32_t size_q6 = brush.size().raw;
  // Below 2^30.
  Extent x = {(limits.x0 * size_q6) >> 6, (limits.x1 * size_q6) >> 6};
  Extent y = {(limits.y0 * size_q6) >> 6, (limits.y1 * size_q6) >> 6};
  if (!brush.is_upright()) {
    const Brush::Axes& axes = brush.axes();
    const Extent x_right = extent_of(x, axes.x_right);
    const Extent x_up = extent_of(x, axes.x_up);
    const Extent y_right = extent_of(y, axes.y_right);
    const Extent y_up = extent_of(y, axes.y_up);
    x = {x_right.low + y_right.low, x_right.high + y_right.high};
    y = {x_up.low + y_up.low, x_up.high + y_up.high};
  }
  // A pixel generous on each side, because steps are rounded, and what fitting
  // may move.
  const int32_t more = (brush.is_fitted() ? 2 : 1) + brush.painter_reach_px();
  return {to_pixel(origin.x_q10 + x.low) - more,
          to_pixel(origin.y_q10 - y.high) - more,
          to_pixel(origin.x_q10 + x.high) + more + 1,
          to_pixel(origin.y_q10 - y.low) + more + 1};
}

void draw_field(const GlyphField& field,
                const Brush& brush,
                FinePoint origin,
                const Sink& sink) noexcept {
  if (brush.is_fitted()) {
    draw_fitted(field, brush, origin, sink);
  } else {
    draw_placed(field, brush, origin, nullptr, sink);
  }
}

void distance_row(const GlyphField& field,
                  const Brush& brush,
                  FinePoint origin,
                  int32_t x,
                  int32_t y,
                  Span<Q6_10> out) noexcept {
  for (Q6_10& distance : out) {
    const FieldPosition at = position_of(brush, origin, x, y);
    int32_t in_px = 0;
    if (brush.is_stretched()) {
      in_px =
          has_fields(field)
              ? detail::stretched_fields_q10(field, brush, at, detail::kNoReach)
              : detail::stretched_samples_q10(field, brush, at);
    } else if (has_fields(field)) {
      in_px = detail::fields_distance_q10(field, brush, at, detail::kNoReach);
    } else {
      in_px = brush.to_px_q10(
          detail::samples_distance_q10(field, at.x_q16, at.y_q16));
    }
    in_px = static_cast<int32_t>(clamp(in_px, INT16_MIN, INT16_MAX));
    distance.raw = static_cast<int16_t>(in_px);
    ++x;
  }
}

}  // namespace inkcell
