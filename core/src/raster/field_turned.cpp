// Glyphs that do not stand upright.
#include "raster/field_turned.hpp"

#include "cells/cell_access.hpp"
#include "place/position.hpp"
#include "raster/field_points.hpp"
#include "raster/field_slanted.hpp"
#include "sink/span_writer.hpp"

namespace inkcell {
namespace detail {
namespace {

FieldPosition position_in(const GlyphField& field,
                          const SlantedPoint& at) noexcept {
  return {wrapped(at.x_q16) + field.x0_u * (1 << 16),
          wrapped(at.y_q16) + field.y0_u * (1 << 16), 0, 0};
}

// Draws the pixels of a row that may show, from a point that goes behind them.
// Only fields can tell how edges are stretched before they are combined.
using DrawRow = void (*)(
    const Slanted&, const Stretching*, SpanWriter&, SlantedPoint&, Range);

// Cells of samples are quartic along a row: every pixel is a query of its own.
void draw_turned_samples(const Slanted& slanted,
                         const Stretching*,
                         SpanWriter& writer,
                         SlantedPoint& at,
                         Range row) noexcept {
  const TextStyle& style = slanted.style;
  for (int32_t x = row.begin; x < row.end; ++x) {
    const FieldPosition place = position_in(slanted.field, at);
    writer.put(x, style.coverage(samples_distance_q10(
                      slanted.field, place.x_q16, place.y_q16)));
    at.go(style.right());
  }
}

void draw_stretched_samples(const Slanted& slanted,
                            const Stretching*,
                            SpanWriter& writer,
                            SlantedPoint& at,
                            Range row) noexcept {
  const TextStyle& style = slanted.style;
  for (int32_t x = row.begin; x < row.end; ++x) {
    const FieldPosition place = position_in(slanted.field, at);
    const int32_t plain =
        samples_distance_q10(slanted.field, place.x_q16, place.y_q16);
    uint8_t coverage = 0;
    if (style.is_opaque(plain)) {
      coverage = 255;
    } else if (!style.is_transparent(plain)) {
      coverage = style.filter().coverage(
          stretched_samples_q10(slanted.field, style, place));
    }
    writer.put(x, coverage);
    at.go(style.right());
  }
}

// Cells of primitives in pixel order.
void draw_slanted_points(const Slanted& slanted,
                         const Stretching* stretching,
                         SpanWriter& writer,
                         SlantedPoint& at,
                         Range row) noexcept {
  draw_points(slanted.field, slanted.style, stretching, at, row, writer);
}

// Row by row.
void draw_slanted_rows(const Slanted& slanted,
                       const Stretching* stretching,
                       SlantedPoint first,
                       const Rect& box,
                       const Sink& sink,
                       DrawRow draw_row) noexcept {
  const TextStyle& style = slanted.style;
  SpanWriter writer(sink, box.y0);
  for (int32_t y = box.y0; y < box.y1; ++y) {
    SlantedPoint at = first;
    int32_t x = box.x0;
    while (x < box.x1 && !slanted.may_show(at)) {
      const int32_t count =
          slanted.count_before(at.x_q16, at.y_q16, box.x1 - x);
      at.go(style.right(), static_cast<uint32_t>(count));
      x += count;
    }
    if (x < box.x1) {
      draw_row(slanted, stretching, writer, at,
               {x, x + slanted.count_shown(at, box.x1 - x)});
    }
    writer.next_row();
    first.go(style.up(), UINT32_MAX);
  }
}

// The centre of a pixel in the glyph.
//
// Not inline: its products of 64 bits are large.
__attribute__((noinline)) GlyphWay find_way(const TextStyle& style,
                                            const Placed& placed,
                                            int32_t x,
                                            int32_t y) noexcept {
  return GlyphWay(style, ScreenWay(placed, x, y));
}

// The same from the grid's corner, modulo 2^16 u.
SlantedPoint point_at(const GlyphField& field, const GlyphWay& way) noexcept {
  return {static_cast<uint32_t>(way.x_q16) -
              static_cast<uint32_t>(field.x0_u * (1 << 16)),
          static_cast<uint32_t>(way.y_q16) -
              static_cast<uint32_t>(field.y0_u * (1 << 16)),
          way.x_q20, way.y_q20};
}

// Whether a pixel is not so far away that it could be taken for one in the
// grid.
bool is_near(const GlyphWay& way) noexcept {
  return clamp_i32(way.x_q16) == way.x_q16 && clamp_i32(way.y_q16) == way.y_q16;
}

// Whether all pixels of a box are near. Those around turned grids are; around a
// stretched one the corners may not be.
bool is_near(const TextStyle& style,
             const Placed& placed,
             const Rect& box) noexcept {
  return is_near(find_way(style, placed, box.x0, box.y0)) &&
         is_near(find_way(style, placed, box.x1, box.y0)) &&
         is_near(find_way(style, placed, box.x0, box.y1)) &&
         is_near(find_way(style, placed, box.x1, box.y1));
}

// The pixels of a window that a glyph may show something in: none if a painter
// has moved it too far away.
Rect shown_box(const GlyphField& field,
               const TextStyle& style,
               const FinePoint& origin,
               const Rect& window,
               Placed& placed) noexcept {
  return placed.set(origin) ? intersect(box_of(field, style, placed), window)
                            : Rect();
}

// Cells of primitives.
void draw_slanted_fields(const Slanted& slanted,
                         const Stretching* stretching,
                         const SlantedPoint& first,
                         const Rect& box,
                         const Sink& sink) noexcept {
  if (kObjectOrder) {
    draw_slanted(slanted, stretching, first, box, sink);
  } else {
    draw_slanted_rows(slanted, stretching, first, box, sink,
                      draw_slanted_points);
  }
}

void paint_turned(const GlyphField& field,
                  const TextStyle& style,
                  const void*,
                  const FinePoint& origin,
                  const Sink& sink) {
  Placed placed;
  const Rect box = shown_box(field, style, origin, sink.window, placed);
  if (is_empty(box)) {
    return;
  }
  const Slanted slanted(field, style);
  const SlantedPoint first =
      point_at(field, find_way(style, placed, box.x0, box.y0));
  if (has_fields(field)) {
    draw_slanted_fields(slanted, nullptr, first, box, sink);
  } else {
    draw_slanted_rows(slanted, nullptr, first, box, sink, draw_turned_samples);
  }
}

// Pixels that are near.
void draw_stretched(const Slanted& slanted,
                    const SlantedPoint& first,
                    const Rect& box,
                    const Sink& sink) noexcept {
  if (has_fields(slanted.field)) {
    const TextStyle& style = slanted.style;
    const int32_t reach_q22 = reach_of(style.filter());
    const Stretching stretching = {stretched_value, style, reach_q22,
                                   far_q22(style, reach_q22)};
    draw_slanted_fields(slanted, &stretching, first, box, sink);
  } else {
    draw_slanted_rows(slanted, nullptr, first, box, sink,
                      draw_stretched_samples);
  }
}

void paint_stretched(const GlyphField& field,
                     const TextStyle& style,
                     const void*,
                     const FinePoint& origin,
                     const Sink& sink) {
  Placed placed;
  const Rect box = shown_box(field, style, origin, sink.window, placed);
  if (is_empty(box)) {
    return;
  }
  const Slanted slanted(field, style);
  if (is_near(style, placed, box)) {
    draw_stretched(slanted,
                   point_at(field, find_way(style, placed, box.x0, box.y0)),
                   box, sink);
    return;
  }
  // Every pixel for itself.
  for (int32_t y = box.y0; y < box.y1; ++y) {
    for (int32_t x = box.x0; x < box.x1; ++x) {
      const GlyphWay way = find_way(style, placed, x, y);
      const SlantedPoint at = point_at(field, way);
      if (is_near(way) && slanted.may_show(at)) {
        draw_stretched(slanted, at, {x, y, x + 1, y + 1}, sink);
      }
    }
  }
}

// From `low` to `high`, in px. [Q10]
struct Extent {
  int32_t low;
  int32_t high;
};

// From one place in the glyph to another, in px, along an axis of the screen.
//
// Not inline: products of 64 bits are large.
__attribute__((noinline)) Extent extent_of(Extent place_q10,
                                           Fixed<int32_t, 30> factor) noexcept {
  const auto low =
      static_cast<int32_t>((int64_t{place_q10.low} * factor.raw) >> 30);
  const auto high =
      static_cast<int32_t>((int64_t{place_q10.high} * factor.raw) >> 30);
  return low < high ? Extent{low, high} : Extent{high, low};
}

// The box around a glyph that is not upright.
Rect slanted_box(const Rect& limits,
                 const TextStyle& style,
                 const Placed& placed) {
  const int32_t size_q6 = style.size().raw;
  // Below 2^30.
  const Extent x = {(limits.x0 * size_q6) >> 6, (limits.x1 * size_q6) >> 6};
  const Extent y = {(limits.y0 * size_q6) >> 6, (limits.y1 * size_q6) >> 6};
  const TextStyle::Axes& axes = style.axes();
  const Extent x_right = extent_of(x, axes.x_right);
  const Extent x_up = extent_of(x, axes.x_up);
  const Extent y_right = extent_of(y, axes.y_right);
  const Extent y_up = extent_of(y, axes.y_up);
  // A pixel generous on each side, because steps are rounded.
  return {((placed.x_q10 + x_right.low + y_right.low) >> 10) - 1,
          ((placed.y_q10 - x_up.high - y_up.high) >> 10) - 1,
          ((placed.x_q10 + x_right.high + y_right.high) >> 10) + 2,
          ((placed.y_q10 - x_up.low - y_up.low) >> 10) + 2};
}

// (a p + b q) / 2^30, for any a and b below 2^42, p and q below 2^31. Not
// inline for its size.
__attribute__((noinline)) int64_t turned(int64_t a,
                                         int64_t p,
                                         int64_t b,
                                         int64_t q) noexcept {
  // The products pass 64 bits, those of the halves do not.
  constexpr int64_t kLow = (1 << 20) - 1;
  const int64_t high = (a >> 20) * p + (b >> 20) * q;
  const int64_t low = (a & kLow) * p + (b & kLow) * q;
  return (high + (low >> 20)) >> 10;
}

FinePoint slanted_place(const TextStyle& style,
                        const FinePoint& origin,
                        int64_t along_q10,
                        int64_t across_q10) {
  const TextStyle::Axes& axes = style.axes();
  return {origin.x_q10 +
              turned(along_q10, axes.x_right.raw, across_q10, axes.y_right.raw),
          origin.y_q10 -
              turned(along_q10, axes.x_up.raw, across_q10, axes.y_up.raw)};
}

}  // namespace

const Slant kTurned = {paint_turned, slanted_box, slanted_place};
const Slant kStretched = {paint_stretched, slanted_box, slanted_place};

}  // namespace detail
}  // namespace inkcell
