// Sub-pixels of upright glyphs of fields, where stripes stand side by side:
// rows of points with a distance for each stripe.
#include "field_row.hpp"
#include "lcd_stripes.hpp"

namespace inkcell {
namespace detail {
namespace {

class StripeRow {
 public:
  StripeRow(const GlyphField& field, const LcdRows& rows) noexcept
      : rows_(rows),
        filter_(rows.brush.filter()),
        field_(field),
        row_(field,
             scale_of(rows.brush),
             reach_of(filter_) + (kFlattest << 12),
             {static_cast<uint32_t>(rows.brush.step_along_q16()), 1 << 20}) {}

  // To the first row of pixels, or the next one. False: it lies beside the
  // grid.
  bool go_to(int32_t y) noexcept {
    if (y == rows_.box.y0 || rows_.map != nullptr) {
      at_ = rows_.at(rows_.box.x0, y, 0, 0);
    } else {
      at_.y_q16 -= rows_.brush.step_along_q16();
      at_.y_q20 -= 1 << 20;
    }
    const FieldPosition& at = at_;
    row_.go_to(at.y_q16, at.y_q20);
    first_ = row_.point(at.x_q16, at.x_q20);
    const int32_t y_u = at.y_q16 >> 16;
    return y_u >= field_.y0_u && y_u < field_.y1_u();
  }

  // What the stripes of `count` pixels cover, three for each; kMost pixels at
  // the most.
  static constexpr int32_t kMost = 12;
  __attribute__((noinline)) void take(int32_t x,
                                      int32_t count,
                                      uint8_t* out) const noexcept {
    int32_t line[3 * kMost];
    fill(x, count, line);
    const int32_t centre = (filter_.outside_q10 + filter_.inside_q10) >> 1;
    const int32_t far_q22 = row_.thirds_reach_q22();
    const int32_t near_q22 = reach_of(filter_) + (kFlattest << 12);
    const int32_t* d = line;
    for (uint8_t* const end = out + 3 * count; out != end; d += 3, out += 3) {
      // Beyond `far` the outer two may be any.
      if (d[1] <= -far_q22 ||
          (d[0] <= -near_q22 && d[1] <= -near_q22 && d[2] <= -near_q22)) {
        out[0] = out[1] = out[2] = 0;
      } else if (d[1] >= far_q22) {
        out[0] = out[1] = out[2] = 255;
      } else {
        const int32_t before = (d[0] >> 12) - centre;
        const int32_t middle = (d[1] >> 12) - centre;
        const int32_t behind = (d[2] >> 12) - centre;
        const int32_t steepness = steepness_q8(
            greater(magnitude(middle - before), magnitude(behind - middle)));
        out[0] = filter_.coverage(centre + ((before * steepness) >> 8));
        out[1] = filter_.coverage(centre + ((middle * steepness) >> 8));
        out[2] = filter_.coverage(centre + ((behind * steepness) >> 8));
      }
    }
  }

 private:
  // Far outside beside the grid. [px, Q22]
  void fill(int32_t x, int32_t count, int32_t* out) const noexcept {
    const auto way = static_cast<uint32_t>(x - rows_.box.x0);
    const auto step_q16 = static_cast<uint32_t>(rows_.brush.step_along_q16());
    RowPoint at = {first_.x_q16 + way * step_q16, first_.x_q20 + (way << 20)};
    const int32_t* const end = out + 3 * count;
    const uint32_t width_q16 =
        static_cast<uint32_t>(field_.x1_u() - field_.x0_u) << 16;
    // To the left of the grid it has wrapped.
    while (out != end && at.x_q16 >= width_q16) {
      out = put_far(out);
      at.x_q16 += step_q16;
      at.x_q20 += 1 << 20;
    }
    int32_t inside = 0;
    for (uint32_t x_q16 = at.x_q16;
         out + 3 * inside != end && x_q16 < width_q16; x_q16 += step_q16) {
      ++inside;
    }
    if (inside != 0) {
      row_.take_thirds(at, out, inside);
      out += 3 * inside;
    }
    while (out != end) {
      out = put_far(out);
    }
  }
  static int32_t* put_far(int32_t* out) noexcept {
    out[0] = out[1] = out[2] = INT32_MIN;
    return out + 3;
  }

  const LcdRows& rows_;
  const Filter& filter_;
  const GlyphField& field_;
  FieldRow row_;
  FieldPosition at_ = {};  // of the row's first pixel
  RowPoint first_ = {0, 0};
};

// Channels of pixels from their stripes: each is the mean of three, the first
// one's of the stripe before the pixel and two of its own. False: all are 0.
inline bool mix(const uint8_t* stripes,
                int32_t count,
                bool red_first,
                uint8_t* rgb) noexcept {
  const uint32_t first = red_first ? 0 : 2;
  uint32_t any = 0;
  for (const uint8_t* const end = stripes + 3 * count; stripes != end;
       stripes += 3, rgb += 3) {
    const int32_t sum = stripes[1] + stripes[2];
    const int32_t next = stripes[2] + stripes[3];
    const uint8_t before = third(stripes[0] + sum);
    const uint8_t middle = third(sum + stripes[3]);
    const uint8_t behind = third(next + stripes[4]);
    rgb[first] = before;
    rgb[1] = middle;
    rgb[2 - first] = behind;
    any |= static_cast<uint32_t>(before | middle | behind);
  }
  return any != 0;
}

// A row of pixels. Each takes a stripe of the one on either side:
//
//   | . . 0 | 1 2 3 | 4 . . |     1 2 3 are those of pixel x
//
__attribute__((noinline)) void draw_row(const StripeRow& row,
                                        const LcdRows& rows,
                                        const LcdStyle& style,
                                        int32_t y,
                                        const Sink& sink) noexcept {
  const Rect& box = rows.box;
  // What lies beside the box covers nothing, unless the window cuts it off.
  const int32_t end = box.x1 + (box.x1 == sink.window.x1 ? 1 : 0);
  uint8_t covered[4 + 3 * StripeRow::kMost];
  covered[0] = covered[1] = covered[2] = covered[3] = 0;
  // Pixel x comes first in `covered`: at first one that is not to be drawn.
  int32_t x = box.x0 - 1;
  if (box.x0 == sink.window.x0) {
    row.take(x, 1, covered + 1);
  }
  for (int32_t skipped = 1; x < box.x1; skipped = 0) {
    const int32_t count = lesser(box.x1 - x, StripeRow::kMost);
    covered[1 + 3 * count] = 0;
    row.take(x + 1, lesser(end - x - 1, count), covered + 4);
    uint8_t rgb[3 * StripeRow::kMost];
    if (mix(covered + 3 * skipped, count - skipped, is_red_first(style.order),
            rgb)) {
      hand_on(sink, style, x + skipped, y, rgb, count - skipped);
    }
    const uint8_t* const last = covered + 3 * count;
    covered[0] = last[0];
    covered[1] = last[1];
    covered[2] = last[2];
    covered[3] = last[3];
    x += count;
  }
}

}  // namespace

void draw_stripe_rows(const GlyphField& field,
                      const LcdRows& rows,
                      const LcdStyle& style,
                      const Sink& sink) noexcept {
  StripeRow row(field, rows);
  for (int32_t y = rows.box.y0; y < rows.box.y1; ++y) {
    if (row.go_to(y)) {
      draw_row(row, rows, style, y, sink);
    }
  }
}

}  // namespace detail
}  // namespace inkcell
