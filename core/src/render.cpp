#include "inkcell/render.hpp"

namespace inkcell {
namespace {

// Collects coverage from left to right along one row and hands it on in spans:
// transparent pixels are dropped, solid ones of saturated cells join to runs.
class SpanWriter {
 public:
  SpanWriter(const Sink& sink, int32_t y) noexcept : sink_(sink), y_(y) {}

  void put(int32_t x, uint8_t coverage) noexcept {
    if (count_ == 0) {
      flush_solid();
      if (coverage == 0) {
        return;
      }
      x_ = x;
    }
    buffer_[count_++] = coverage;
    if (count_ == kMaxSpan) {
      flush_span();
    }
  }

  void solid(int32_t x, int32_t count) noexcept {
    flush_span();
    if (solid_count_ == 0) {
      x_ = x;
    }
    solid_count_ += count;
  }

  void flush() noexcept {
    flush_span();
    flush_solid();
  }

 private:
  void flush_span() noexcept {
    while (count_ > 0 && buffer_[count_ - 1] == 0) {
      --count_;
    }
    if (count_ > 0) {
      sink_.coverage(sink_.context, x_, y_, buffer_, count_);
      count_ = 0;
    }
  }

  void flush_solid() noexcept {
    if (solid_count_ > 0) {
      sink_.solid(sink_.context, x_, y_, solid_count_);
      solid_count_ = 0;
    }
  }

  const Sink& sink_;
  int32_t y_;
  int32_t x_ = 0;
  int32_t count_ = 0;
  int32_t solid_count_ = 0;
  uint8_t buffer_[kMaxSpan];
};

// Where the centre of pixel (x, y) lies in the glyph. [u, Q16]
//
// Linear in x and y with whole steps: neighbours differ by exactly the brush's
// step, so that it does not matter where a row or a strip begins. Within the
// box of a field positions stay below 2^31: its grid ends at 15360 u, twice
// that in a corner of the box around a turned grid.
struct Position {
  int32_t x_q16;
  int32_t y_q16;
};

int32_t clamp_i32(int64_t value) noexcept {
  if (value < INT32_MIN) {
    return INT32_MIN;
  }
  return static_cast<int32_t>(value > INT32_MAX ? INT32_MAX : value);
}

Position position_of(const Brush& brush,
                     const FinePoint& origin,
                     int32_t x,
                     int32_t y) noexcept {
  const int64_t right = int64_t{x} * 1024 + 512 - origin.x_q10;
  const int64_t up = origin.y_q10 - (int64_t{y} * 1024 + 512);
  const int64_t along = brush.step_along_q16();
  const int64_t across = brush.step_across_q16();
  return {clamp_i32((right * along + up * across) >> 10),
          clamp_i32((up * along - right * across) >> 10)};
}

// Pixels of a row: begin <= x < end.
struct Range {
  int32_t begin;
  int32_t end;
};

// Clamps to what int32_t pixels and their positions can bear.
int32_t to_pixel(int64_t px_q10) noexcept {
  constexpr int64_t kLimit = int64_t{1} << 30;
  const int64_t px = px_q10 >> 10;
  if (px < -kLimit) {
    return -static_cast<int32_t>(kLimit);
  }
  return static_cast<int32_t>(px > kLimit ? kLimit : px);
}

// A length in u as one in px. [Q10]
int64_t to_px_q10(const Brush& brush, int32_t length_u) noexcept {
  return (int64_t{length_u} * brush.size().raw) >> 6;
}

// The pixels, before clipping, that can have their centres in the grid; one
// pixel generous on each side because steps are rounded.
Rect upright_box(const GlyphField& field,
                 const Brush& brush,
                 const FinePoint& origin) noexcept {
  const int64_t left = origin.x_q10 + to_px_q10(brush, field.x0_u);
  const int64_t right = origin.x_q10 + to_px_q10(brush, field.x1_u());
  const int64_t top = origin.y_q10 - to_px_q10(brush, field.y1_u());
  const int64_t bottom = origin.y_q10 - to_px_q10(brush, field.y0_u);
  return {to_pixel(left) - 1, to_pixel(top) - 1, to_pixel(right) + 2,
          to_pixel(bottom) + 2};
}

// The box around the four corners of a turned grid.
Rect turned_box(const GlyphField& field,
                const Brush& brush,
                const FinePoint& origin) noexcept {
  const int64_t cosine = brush.direction().cosine.raw;
  const int64_t sine = brush.direction().sine.raw;
  int64_t low_x = INT64_MAX;
  int64_t low_y = INT64_MAX;
  int64_t high_x = INT64_MIN;
  int64_t high_y = INT64_MIN;
  for (int corner = 0; corner < 4; ++corner) {
    const int64_t along = to_px_q10(
        brush, (corner & 1) != 0 ? field.x1_u() : int32_t{field.x0_u});
    const int64_t across = to_px_q10(
        brush, (corner & 2) != 0 ? field.y1_u() : int32_t{field.y0_u});
    const int64_t x = origin.x_q10 + ((along * cosine - across * sine) >> 30);
    const int64_t y = origin.y_q10 - ((along * sine + across * cosine) >> 30);
    low_x = x < low_x ? x : low_x;
    high_x = x > high_x ? x : high_x;
    low_y = y < low_y ? y : low_y;
    high_y = y > high_y ? y : high_y;
  }
  return {to_pixel(low_x) - 1, to_pixel(low_y) - 1, to_pixel(high_x) + 2,
          to_pixel(high_y) + 2};
}

// One row of upright text: y is constant in the glyph, so that a cell is set up
// once and then costs two products a pixel.
//
// Invariant of the outer loop: `x` is the next pixel, at `x_q16` in the grid.
void draw_upright_row(const GlyphField& field,
                      const Brush& brush,
                      Range pixels,
                      int32_t x_q16,
                      int32_t y_q16,
                      SpanWriter& writer) noexcept {
  const int32_t step = brush.step_along_q16();
  int32_t x = pixels.begin;
  while (x < pixels.end) {
    const Cell cell = locate(field, x_q16 >> 16, y_q16 >> 16);
    const int32_t left_q16 = cell.x0_u * (1 << 16);
    const int32_t right_q16 = left_q16 + (int32_t{1} << (16 + cell.size_log2));
    if (cell.samples == nullptr) {
      const int32_t first = x;
      do {
        ++x;
        x_q16 += step;
      } while (x < pixels.end && x_q16 < right_q16);
      if (cell.inside) {
        writer.solid(first, x - first);
      } else {
        writer.flush();
      }
      continue;
    }
    SamplesRow row;
    row.set_up(cell.samples, cell.size_log2, y_q16 - cell.y0_u * (1 << 16));
    do {
      const int32_t distance_u = row.distance_q10(x_q16 - left_q16);
      writer.put(x, brush.filter().coverage(brush.to_px_q10(distance_u)));
      ++x;
      x_q16 += step;
    } while (x < pixels.end && x_q16 < right_q16);
  }
}

void draw_upright(const GlyphField& field,
                  const Brush& brush,
                  const FinePoint& origin,
                  const Rect& box,
                  const Sink& sink) noexcept {
  const int32_t step = brush.step_along_q16();
  const Position first = position_of(brush, origin, box.x0, box.y0);
  const int32_t low_x = field.x0_u * (1 << 16);
  const int32_t high_x = field.x1_u() * (1 << 16);
  Range pixels = {box.x0, box.x1};
  int32_t x_q16 = first.x_q16;
  while (pixels.begin < pixels.end && x_q16 < low_x) {
    ++pixels.begin;
    x_q16 += step;
  }
  int32_t last_q16 = x_q16 + (pixels.end - pixels.begin - 1) * step;
  while (pixels.begin < pixels.end && last_q16 >= high_x) {
    --pixels.end;
    last_q16 -= step;
  }
  if (pixels.begin >= pixels.end) {
    return;
  }
  int32_t y_q16 = first.y_q16;
  for (int32_t y = box.y0; y < box.y1; ++y, y_q16 -= step) {
    const int32_t y_u = y_q16 >> 16;
    if (y_u >= field.y0_u && y_u < field.y1_u()) {
      SpanWriter writer(sink, y);
      draw_upright_row(field, brush, pixels, x_q16, y_q16, writer);
      writer.flush();
    }
  }
}

// Slanted text: cells are quartic along a row, so that every pixel is a query
// of its own.
void draw_turned(const GlyphField& field,
                 const Brush& brush,
                 const FinePoint& origin,
                 const Rect& box,
                 const Sink& sink) noexcept {
  for (int32_t y = box.y0; y < box.y1; ++y) {
    SpanWriter writer(sink, y);
    Position at = position_of(brush, origin, box.x0, y);
    for (int32_t x = box.x0; x < box.x1; ++x) {
      const Q22_10 distance = distance_at(field, Q16_16::from_raw(at.x_q16),
                                          Q16_16::from_raw(at.y_q16));
      writer.put(x, brush.filter().coverage(brush.to_px_q10(distance.raw)));
      at.x_q16 += brush.step_along_q16();
      at.y_q16 -= brush.step_across_q16();
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
  return brush.is_upright() ? upright_box(field, brush, origin)
                            : turned_box(field, brush, origin);
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
    const Position at = position_of(brush, origin, x, y);
    const Q22_10 in_u = distance_at(field, Q16_16::from_raw(at.x_q16),
                                    Q16_16::from_raw(at.y_q16));
    distance.raw = static_cast<int16_t>(brush.to_px_q10(in_u.raw));
    ++x;
  }
}

}  // namespace inkcell
