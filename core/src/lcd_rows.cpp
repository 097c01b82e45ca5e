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

  // To another row of pixels. False: it lies beside the grid.
  bool go_to(int32_t y) noexcept {
    const FieldPosition at = rows_.at(rows_.box.x0, y, 0, 0);
    row_.go_to(at.y_q16, at.y_q20);
    first_ = row_.point(at.x_q16, at.x_q20);
    const int32_t y_u = at.y_q16 >> 16;
    return y_u >= field_.y0_u && y_u < field_.y1_u();
  }

  // What the stripes of `count` pixels cover, three for each; kMost pixels at
  // the most.
  static constexpr int32_t kMost = 8;
  __attribute__((noinline)) void take(int32_t x,
                                      int32_t count,
                                      uint8_t* out) const noexcept {
    int32_t line[3 * kMost];
    fill(x, count, line);
    const int32_t far_q10 = row_.thirds_reach_q22() >> 12;
    const int32_t* d = line;
    for (uint8_t* const end = out + 3 * count; out != end; out += 3) {
      int32_t d_q10[3];
      for (int32_t& at_q10 : d_q10) {
        // Beyond, they may be any.
        at_q10 = lesser(far_q10, greater(-far_q10, *d++ >> 12));
      }
      if (d_q10[1] == -far_q10) {
        out[0] = out[1] = out[2] = 0;
      } else {
        cover_stripes<3>(filter_, d_q10, out);
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
  RowPoint first_ = {0, 0};
};

// A row of pixels. Each takes a stripe of the one on either side:
//
//   | . . 0 | 1 2 3 | 4 . . |     1 2 3 are those of pixel x
//
__attribute__((noinline)) void draw_row(const StripeRow& row,
                                        const LcdRows& rows,
                                        const Rect& window,
                                        RgbSpans& spans) noexcept {
  const Rect& box = rows.box;
  // What lies beside the box covers nothing, unless the window cuts it off.
  const int32_t end = box.x1 + (box.x1 == window.x1 ? 1 : 0);
  uint8_t covered[4 + 3 * StripeRow::kMost] = {};
  int32_t x = box.x0 - 1;
  if (box.x0 == window.x0) {
    row.take(x, 1, covered + 1);
  }
  while (x < box.x1) {
    const int32_t count = lesser(box.x1 - x, StripeRow::kMost);
    const int32_t known = lesser(end - x - 1, count);
    covered[1 + 3 * count] = 0;
    row.take(x + 1, known, covered + 4);
    const uint8_t* stripes = covered;
    for (const int32_t stop = x + count; x < stop; ++x) {
      if (x >= box.x0) {
        spans.put(x, stripes);
      }
      stripes += 3;
    }
    for (uint32_t i = 0; i < 4; ++i) {
      covered[i] = stripes[i];
    }
  }
}

}  // namespace

void draw_stripe_rows(const GlyphField& field,
                      const LcdRows& rows,
                      const LcdStyle& style,
                      const Sink& sink) noexcept {
  StripeRow row(field, rows);
  RgbSpans spans(sink, style, rows.box.y0);
  for (int32_t y = rows.box.y0; y < rows.box.y1; ++y) {
    if (row.go_to(y)) {
      draw_row(row, rows, sink.window, spans);
    }
    spans.next_row();
  }
}

}  // namespace detail
}  // namespace inkcell
