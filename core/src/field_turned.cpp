// Glyphs that do not stand upright, row by row.
//
// A row begins where its first pixel meets the limits of what may show, and
// ends where the last one does.
#include "field_turned.hpp"

#include "cell_access.hpp"
#include "field_slanted.hpp"
#include "position.hpp"

namespace inkcell {
namespace detail {
namespace {

FieldPosition position_in(const GlyphField& field,
                          const RowPoint& at) noexcept {
  return {wrapped(at.x_q16) + field.x0_u * (1 << 16),
          wrapped(at.y_q16) + field.y0_u * (1 << 16), 0, 0};
}

// The same for cells of samples, which are quartic along a row: every pixel is
// a query of its own.
void draw_turned_samples(Slanted& slanted,
                         RowPoint at,
                         int32_t x,
                         int32_t count) noexcept {
  const Brush& brush = slanted.brush;
  for (const int32_t end = x + count; x < end; ++x) {
    const FieldPosition place = position_in(slanted.field, at);
    slanted.writer.put(x, brush.coverage(samples_distance_q10(
                              slanted.field, place.x_q16, place.y_q16)));
    at.go(brush.right());
  }
}

void draw_stretched_samples(Slanted& slanted,
                            RowPoint at,
                            int32_t x,
                            int32_t count) noexcept {
  const Brush& brush = slanted.brush;
  for (const int32_t end = x + count; x < end; ++x) {
    const FieldPosition place = position_in(slanted.field, at);
    const int32_t plain =
        samples_distance_q10(slanted.field, place.x_q16, place.y_q16);
    uint8_t coverage = 0;
    if (brush.is_opaque(plain)) {
      coverage = 255;
    } else if (!brush.is_transparent(plain)) {
      coverage = brush.filter().coverage(
          stretched_samples_q10(slanted.field, brush, place));
    }
    slanted.writer.put(x, coverage);
    at.go(brush.right());
  }
}

// The centre of a pixel from the grid's corner, modulo 2^16 u. False where it
// is so far away that it could be taken for one in the grid.
//
// Not inline: its products of 64 bits are large.
__attribute__((noinline)) bool find_point(const Slanted& slanted,
                                          const FinePoint& origin,
                                          int32_t x,
                                          int32_t y,
                                          RowPoint& at) noexcept {
  const GlyphField& field = slanted.field;
  const GlyphWay way(slanted.brush, ScreenWay(origin, x, y));
  at = {static_cast<uint32_t>(way.x_q16) -
            static_cast<uint32_t>(field.x0_u * (1 << 16)),
        static_cast<uint32_t>(way.y_q16) -
            static_cast<uint32_t>(field.y0_u * (1 << 16)),
        way.x_q20, way.y_q20};
  return clamp_i32(way.x_q16) == way.x_q16 && clamp_i32(way.y_q16) == way.y_q16;
}

// Whether no pixel of a box is so far away. Those around turned grids never
// are; around a stretched one the corners may be.
bool is_near(const Slanted& slanted,
             const FinePoint& origin,
             const Rect& box) noexcept {
  RowPoint corner;
  return find_point(slanted, origin, box.x0, box.y0, corner) &&
         find_point(slanted, origin, box.x1, box.y0, corner) &&
         find_point(slanted, origin, box.x0, box.y1, corner) &&
         find_point(slanted, origin, box.x1, box.y1, corner);
}

using DrawRow = void (*)(Slanted&, RowPoint, int32_t, int32_t);

// Every pixel for itself.
__attribute__((noinline)) void paint_far(Slanted& slanted,
                                         const FinePoint& origin,
                                         const Rect& box,
                                         DrawRow draw_row) noexcept {
  for (int32_t y = box.y0; y < box.y1; ++y) {
    for (int32_t x = box.x0; x < box.x1; ++x) {
      RowPoint at;
      if (find_point(slanted, origin, x, y, at) && slanted.may_show(at)) {
        draw_row(slanted, at, x, 1);
      }
    }
    slanted.writer.next_row();
  }
}

// Row by row, all of the box being near.
void paint(Slanted& slanted,
           const FinePoint& origin,
           const Rect& box,
           DrawRow draw_row) noexcept {
  const GlyphStep& right = slanted.brush.right();
  const GlyphStep& up = slanted.brush.up();
  RowPoint start;
  static_cast<void>(find_point(slanted, origin, box.x0, box.y0, start));
  for (int32_t y = box.y0; y < box.y1; ++y) {
    RowPoint at = start;
    int32_t x = box.x0;
    while (x < box.x1 && !slanted.may_show(at)) {
      at.x_q16 += static_cast<uint32_t>(right.x_q16);
      at.y_q16 += static_cast<uint32_t>(right.y_q16);
      ++x;
    }
    if (x < box.x1) {
      const auto before = static_cast<uint32_t>(x - box.x0);
      at.x_q20 += times(right.x_q20, before);
      at.y_q20 += times(right.y_q20, before);
      draw_row(slanted, at, x, slanted.count_shown(at, box.x1 - x));
    }
    slanted.writer.next_row();
    start.x_q16 -= static_cast<uint32_t>(up.x_q16);
    start.y_q16 -= static_cast<uint32_t>(up.y_q16);
    start.x_q20 -= static_cast<uint32_t>(up.x_q20);
    start.y_q20 -= static_cast<uint32_t>(up.y_q20);
  }
}

void paint_turned(const GlyphField& field,
                  const Brush& brush,
                  const void*,
                  const FinePoint& origin,
                  const RowMap*,
                  const Sink& sink) {
  const Rect box = intersect(field_box(field, brush, origin), sink.window);
  if (!is_empty(box)) {
    Slanted slanted(field, brush, nullptr, sink, box.y0);
    paint(slanted, origin, box,
          has_fields(field) ? draw_slanted_row : draw_turned_samples);
  }
}

void paint_stretched(const GlyphField& field,
                     const Brush& brush,
                     const void*,
                     const FinePoint& origin,
                     const RowMap*,
                     const Sink& sink) {
  const Rect box = intersect(field_box(field, brush, origin), sink.window);
  if (!is_empty(box)) {
    Slanted slanted(field, brush, stretched_value, sink, box.y0);
    slanted.far_q22 = far_q22(brush, slanted.reach_q22);
    const DrawRow draw_row =
        has_fields(field) ? draw_slanted_row : draw_stretched_samples;
    if (is_near(slanted, origin, box)) {
      paint(slanted, origin, box, draw_row);
    } else {
      paint_far(slanted, origin, box, draw_row);
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
Rect slanted_box(const Rect& limits, const Brush& brush, const Placed& placed) {
  const int32_t size_q6 = brush.size().raw;
  // Below 2^30.
  const Extent x = {(limits.x0 * size_q6) >> 6, (limits.x1 * size_q6) >> 6};
  const Extent y = {(limits.y0 * size_q6) >> 6, (limits.y1 * size_q6) >> 6};
  const Brush::Axes& axes = brush.axes();
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

FinePoint slanted_place(const Brush& brush,
                        const FinePoint& origin,
                        int64_t along_q10,
                        int64_t across_q10) {
  const Brush::Axes& axes = brush.axes();
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
