#include "inkcell/render.hpp"

#include "cell_access.hpp"
#include "field_cell.hpp"
#include "field_draw.hpp"
#include "span_writer.hpp"

namespace inkcell {
namespace {

using detail::FieldPosition;
using detail::Range;
using detail::SpanWriter;

// What a row of a cell shows.
enum class Side : uint8_t { outside, inside, both };

Side side_of(const SamplesRow& row, const Brush& brush) noexcept {
  const SamplesRow::Bounds bounds = row.bounds_q10();
  if (brush.is_transparent(bounds.high)) {
    return Side::outside;
  }
  return brush.is_opaque(bounds.low) ? Side::inside : Side::both;
}

int64_t clamp(int64_t value, int64_t low, int64_t high) noexcept {
  if (value < low) {
    return low;
  }
  return value > high ? high : value;
}

int32_t clamp_i32(int64_t value) noexcept {
  return static_cast<int32_t>(clamp(value, INT32_MIN, INT32_MAX));
}

// How far one pixel to the right leads in px along the glyph's axes. [Q20]
int32_t along_q20(const Brush& brush) noexcept {
  return brush.direction().cosine.raw >> 10;
}
int32_t across_q20(const Brush& brush) noexcept {
  return brush.direction().sine.raw >> 10;
}

// Where the centre of pixel (x, y) lies in the glyph.
//
// Linear in x and y with whole steps: neighbours differ by exactly the brush's
// step, so that it does not matter where a row or a strip begins. Within the
// box of a field positions in u stay below 2^31: its grid ends at 15360 u,
// twice that in a corner of the box around a turned grid.
FieldPosition position_of(const Brush& brush,
                          const FinePoint& origin,
                          int32_t x,
                          int32_t y) noexcept {
  // Far from anything to see, but within 64 bits once multiplied.
  constexpr int64_t kFar = int64_t{1} << 37;
  const int64_t right =
      clamp(int64_t{x} * 1024 + 512 - origin.x_q10, -kFar, kFar);
  const int64_t up =
      clamp(origin.y_q10 - (int64_t{y} * 1024 + 512), -kFar, kFar);
  const int64_t along = brush.step_along_q16();
  const int64_t across = brush.step_across_q16();
  const int64_t along_px = along_q20(brush);
  const int64_t across_px = across_q20(brush);
  // Half of what is cut off on the way to 1/256 px.
  constexpr int64_t kHalf = 1 << 11;
  return {clamp_i32((right * along + up * across) >> 10),
          clamp_i32((up * along - right * across) >> 10),
          static_cast<uint32_t>(((right * along_px + up * across_px) >> 10) +
                                kHalf),
          static_cast<uint32_t>(((up * along_px - right * across_px) >> 10) +
                                kHalf)};
}

bool has_fields(const GlyphField& field) noexcept {
  return INKCELL_FIELD_CELLS != 0 && field.kind != GlyphField::Kind::samples;
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

// From one place in the glyph to another, in px, times a sine or cosine.
Extent extent_of(const Brush& brush,
                 int32_t low_u,
                 int32_t high_u,
                 Fixed<int32_t, 30> factor) noexcept {
  const int32_t low_q10 = (low_u * brush.size().raw) >> 6;  // below 2^30
  const int32_t high_q10 = (high_u * brush.size().raw) >> 6;
  const int64_t low = (int64_t{low_q10} * factor.raw) >> 30;
  const int64_t high = (int64_t{high_q10} * factor.raw) >> 30;
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

void draw_upright(const GlyphField& field,
                  const Brush& brush,
                  const FinePoint& origin,
                  const Rect& box,
                  const Sink& sink) noexcept {
  const int32_t step = brush.step_along_q16();
  FieldPosition at = position_of(brush, origin, box.x0, box.y0);
  const int32_t low_x = field.x0_u * (1 << 16);
  const int32_t high_x = field.x1_u() * (1 << 16);
  Range pixels = {box.x0, box.x1};
  while (pixels.begin < pixels.end && at.x_q16 < low_x) {
    ++pixels.begin;
    at.x_q16 += step;
    at.x_q20 += 1 << 20;
  }
  int32_t last_q16 = at.x_q16 + (pixels.end - pixels.begin - 1) * step;
  while (pixels.begin < pixels.end && last_q16 >= high_x) {
    --pixels.end;
    last_q16 -= step;
  }
  if (pixels.begin >= pixels.end) {
    return;
  }
  for (int32_t y = box.y0; y < box.y1; ++y) {
    const int32_t y_u = at.y_q16 >> 16;
    if (y_u >= field.y0_u && y_u < field.y1_u()) {
      SpanWriter writer(sink, y);
      if (has_fields(field)) {
        detail::draw_fields_row(field, brush, pixels, at, writer);
      } else {
        draw_upright_row(field, brush, pixels, at.x_q16, at.y_q16, writer);
      }
      writer.flush();
    }
    at.y_q16 -= step;
    at.y_q20 -= 1 << 20;
  }
}

// Slanted text: cells of samples are quartic along a row, so that every pixel
// is a query of its own.
__attribute__((noinline)) void draw_turned(const GlyphField& field,
                                           const Brush& brush,
                                           const FinePoint& origin,
                                           const Rect& box,
                                           const Sink& sink) noexcept {
  const int32_t reach_q22 = detail::reach_of(brush.filter());
  for (int32_t y = box.y0; y < box.y1; ++y) {
    SpanWriter writer(sink, y);
    FieldPosition at = position_of(brush, origin, box.x0, y);
    for (int32_t x = box.x0; x < box.x1; ++x) {
      const uint8_t coverage =
          has_fields(field)
              ? brush.filter().coverage(
                    detail::fields_distance_q10(field, brush, at, reach_q22))
              : brush.coverage(
                    detail::samples_distance_q10(field, at.x_q16, at.y_q16));
      writer.put(x, coverage);
      at.x_q16 += brush.step_along_q16();
      at.y_q16 -= brush.step_across_q16();
      at.x_q20 += static_cast<uint32_t>(along_q20(brush));
      at.y_q20 -= static_cast<uint32_t>(across_q20(brush));
    }
    writer.flush();
  }
}

}  // namespace

Rect field_box(const GlyphField& field,
               const Brush& brush,
               FinePoint origin) noexcept {
  if (field.tiles_x == 0 || field.tiles_y == 0) {
    return {};
  }
  const Direction turn = brush.direction();
  const int32_t x0 = field.x0_u;
  const int32_t y0 = field.y0_u;
  const Extent x_right = extent_of(brush, x0, field.x1_u(), turn.cosine);
  const Extent x_up = extent_of(brush, x0, field.x1_u(), turn.sine);
  const Extent y_left = extent_of(brush, y0, field.y1_u(), turn.sine);
  const Extent y_up = extent_of(brush, y0, field.y1_u(), turn.cosine);
  // A pixel generous on each side, because steps are rounded.
  return {to_pixel(origin.x_q10 + x_right.low - y_left.high) - 1,
          to_pixel(origin.y_q10 - x_up.high - y_up.high) - 1,
          to_pixel(origin.x_q10 + x_right.high - y_left.low) + 2,
          to_pixel(origin.y_q10 - x_up.low - y_up.low) + 2};
}

void draw_field(const GlyphField& field,
                const Brush& brush,
                FinePoint origin,
                const Sink& sink) noexcept {
  const Rect box = intersect(field_box(field, brush, origin), sink.window);
  if (is_empty(box)) {
    return;
  }
  if (brush.is_upright()) {
    draw_upright(field, brush, origin, box, sink);
  } else {
    draw_turned(field, brush, origin, box, sink);
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
    if (has_fields(field)) {
      in_px = detail::fields_distance_q10(field, brush, at, detail::kNoReach);
      in_px = static_cast<int32_t>(clamp(in_px, INT16_MIN, INT16_MAX));
    } else {
      in_px = brush.to_px_q10(
          detail::samples_distance_q10(field, at.x_q16, at.y_q16));
    }
    distance.raw = static_cast<int16_t>(in_px);
    ++x;
  }
}

}  // namespace inkcell
