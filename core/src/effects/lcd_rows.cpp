// Sub-pixels of upright glyphs of fields: rows of points with a distance for
// each stripe.
#include "effects/lcd_stripes.hpp"
#include "raster/field_row.hpp"

namespace inkcell {
namespace detail {
namespace {

// What turns the distances of a pixel's stripes into coverages.
struct StripeRamp {
  int32_t far_q22;   // beyond it the middle one decides
  int32_t near_q22;  // beyond it a stripe covers nothing
  int32_t centre_q10;
  int32_t first_q10;  // from the centre to the ramp's first step
  uint32_t steps;     // of the ramp
  uint32_t scale;     // entries a step, as in Filter
  const uint8_t* table;

  explicit StripeRamp(const Filter& filter) noexcept
      : near_q22(reach_of(filter) + (kFlattest << 12)),
        centre_q10((filter.outside_q10 + filter.inside_q10) >> 1),
        first_q10(centre_q10 - filter.outside_q10 - 1),
        steps(static_cast<uint32_t>(filter.inside_q10 - filter.outside_q10) -
              1),
        scale(filter.scale),
        table(filter.table) {
    far_q22 = near_q22;
  }
};

// Which pixels of some show something.
struct Shown {
  int32_t begin;
  int32_t end;  // not after `begin` if none
};

// Turns the distances of pixels, three each, into coverages, which may take
// their place. Says which are not 0.
__attribute__((noinline)) Shown cover(const StripeRamp& ramp,
                                      const int32_t* line,
                                      uint8_t* out,
                                      int32_t count) noexcept {
  const int32_t far_q22 = ramp.far_q22;
  const int32_t near_q22 = ramp.near_q22;
  const int32_t centre = ramp.centre_q10;
  const int32_t first = ramp.first_q10;
  const uint32_t steps = ramp.steps;
  const uint32_t scale = ramp.scale;
  const uint8_t* const table = ramp.table;
  const int32_t all = count;
  for (; count != 0 && line[1] <= -far_q22; --count, line += 3, out += 3) {
    out[0] = out[1] = out[2] = 0;
  }
  const int32_t begin = all - count;
  int32_t left = all + 1;  // from the last one on that shows something
  for (; count != 0; --count, line += 3, out += 3) {
    const int32_t at = line[1];
    if (at <= -far_q22 ||
        (at <= -near_q22 && line[0] <= -near_q22 && line[2] <= -near_q22)) {
      out[0] = out[1] = out[2] = 0;
      continue;
    }
    left = count;
    if (at >= far_q22) {
      out[0] = out[1] = out[2] = 255;
      continue;
    }
    const int32_t before = (line[0] >> 12) - centre;
    const int32_t middle = (at >> 12) - centre;
    const int32_t behind = (line[2] >> 12) - centre;
    const int32_t steepness =
        steepness_q8(max(abs(middle - before), abs(behind - middle)));
    // Filter::coverage; entries of its own steps are below 256.
    const auto coverage = [=](int32_t way) -> uint32_t {
      const int32_t step = first + ((way * steepness) >> 8);
      if (static_cast<uint32_t>(step) < steps) {
        const uint32_t entry = (static_cast<uint32_t>(step) + 1) * scale >> 14;
        return table[static_cast<uint8_t>(entry)];
      }
      return ~static_cast<uint32_t>(step >> 31);
    };
    out[0] = static_cast<uint8_t>(coverage(before));
    out[1] = static_cast<uint8_t>(coverage(middle));
    out[2] = static_cast<uint8_t>(coverage(behind));
  }
  return {begin, all - left + 1};
}

// Rows of pixels, three stripes each.
class StripeRow {
 public:
  StripeRow(const GlyphField& field, const LcdRows& rows, bool is_down) noexcept
      : rows_(rows),
        field_(field),
        ramp_(rows.style.filter()),
        row_(field, rows.style, ramp_.near_q22),
        way_(row_.way(is_down, is_down ? -kThirdQ8 : kThirdQ8)) {
    ramp_.far_q22 = way_.far_q22;
  }

  // To the first row of pixels, or to the one below. False: it lies beside the
  // grid.
  bool go_to(int32_t y, bool is_first) noexcept {
    if (is_first) {
      at_ = rows_.at(rows_.box.x0, y, 0, 0);
      find_grid();
    } else {
      at_.y_q16 -= rows_.style.step_along_q16();
      at_.y_q20 -= 1 << 20;
    }
    row_.go_to(at_.y_q16, at_.y_q20);
    const int32_t y_u = at_.y_q16 >> 16;
    return y_u >= field_.y0_u && y_u < field_.y1_u();
  }

  // What the stripes of `count` pixels cover, three for each. `line` has room
  // for as many numbers, and may be where coverages go.
  Shown take(int32_t x,
             int32_t count,
             int32_t* line,
             uint8_t* out) const noexcept {
    fill(x, count, line);
    return cover(ramp_, line, out, count);
  }

 private:
  static constexpr int32_t kThirdQ8 = 85;

  // Which pixels of rows lie in the grid.
  void find_grid() noexcept {
    const int32_t step_q16 = rows_.style.step_along_q16();
    const int32_t left_q16 = field_.x0_u * (1 << 16);
    const int32_t right_q16 = field_.x1_u() * (1 << 16);
    grid_x0_ = rows_.box.x0 - 1;
    grid_x1_ = rows_.box.x1 + 1;
    int32_t x_q16 = at_.x_q16 - step_q16;
    for (; grid_x0_ < grid_x1_ && x_q16 < left_q16; x_q16 += step_q16) {
      ++grid_x0_;
    }
    x_q16 += (grid_x1_ - 1 - grid_x0_) * step_q16;
    for (; grid_x0_ < grid_x1_ && x_q16 >= right_q16; x_q16 -= step_q16) {
      --grid_x1_;
    }
  }

  // Far outside beside the grid. [px, Q22]
  __attribute__((noinline)) void fill(int32_t x,
                                      int32_t count,
                                      int32_t* line) const noexcept {
    const int32_t end = x + count;
    for (; x < end && x < grid_x0_; ++x) {
      line = put_far(line);
    }
    const int32_t inside = min(end, grid_x1_) - x;
    if (inside > 0) {
      const auto way = static_cast<uint32_t>(x - rows_.box.x0);
      const auto step_q16 = static_cast<uint32_t>(rows_.style.step_along_q16());
      RowPoint at = row_.point(at_.x_q16, at_.x_q20);
      at.x_q16 += way * step_q16;
      at.x_q20 += way << 20;
      row_.take_thirds(at, way_, line, inside);
      line += 3 * inside;
      x += inside;
    }
    for (; x < end; ++x) {
      line = put_far(line);
    }
  }
  static int32_t* put_far(int32_t* out) noexcept {
    out[1] = INT32_MIN;
    return out + 3;
  }

  const LcdRows& rows_;
  const GlyphField& field_;
  StripeRamp ramp_;
  FieldRow row_;
  ThirdsWay way_;
  FieldPosition at_ = {};  // of the row's first pixel
  int32_t grid_x0_ = 0;
  int32_t grid_x1_ = 0;
};

// Channels of pixels from their stripes: each is the mean of three, the first
// one's of the stripe before the pixel and two of its own. They come in the
// stripes' place, one byte before the pixel's own.
__attribute__((noinline)) void mix(uint8_t* stripes,
                                   int32_t count,
                                   bool red_first) noexcept {
  const uint32_t first = red_first ? 0 : 2;
  const uint32_t last = 2 - first;
  // third() of products: of three stripes in a row one is in the middle.
  const auto product = [](int32_t stripe) { return 171 * stripe; };
  int32_t before = product(stripes[0]);
  int32_t own = product(stripes[1]);
  for (; count != 0; --count, stripes += 3) {
    const int32_t middle = product(stripes[2]) + 85;
    const int32_t behind = product(stripes[3]);
    const int32_t next = product(stripes[4]);
    const int32_t two = own + middle;
    stripes[first] = static_cast<uint8_t>((before + two) >> 9);
    stripes[1] = static_cast<uint8_t>((two + behind) >> 9);
    stripes[last] = static_cast<uint8_t>((middle + behind + next) >> 9);
    before = behind;
    own = next;
  }
}

// Rows of pixels. Each takes a stripe of the one on either side:
//
//   | . . 0 | 1 2 3 | 4 . . |     1 2 3 are those of pixel x
//
class StripeRows {
 public:
  StripeRows(const LcdRows& rows,
             const LcdOptions& lcd,
             const Sink& sink) noexcept
      : rows_(rows), lcd_(lcd), sink_(sink) {}

  __attribute__((noinline)) void draw(StripeRow& row) noexcept {
    const Rect& box = rows_.box;
    // What lies beside the box covers nothing, unless the window cuts it off.
    const int32_t first = box.x0 - (box.x0 != rows_.all.x0 ? 1 : 0);
    end_ = box.x1 + (box.x1 != rows_.all.x1 ? 1 : 0);
    for (y_ = box.y0; y_ < box.y1; ++y_) {
      if (row.go_to(y_, y_ == box.y0)) {
        before_ = 0;
        for (int32_t x = first; x < end_; x += kMost) {
          draw_part(row, x);
        }
      }
    }
  }

 private:
  static constexpr int32_t kMost = 15;  // what the stack can bear

  // From the pixel before x on.
  __attribute__((noinline)) void draw_part(const StripeRow& row,
                                           int32_t x) noexcept {
    // First come the four stripes before x, then distances become coverages.
    int32_t line[1 + 3 * kMost];
    auto* const stripes = reinterpret_cast<uint8_t*>(line);
    const int32_t count = min(end_ - x, kMost);
    line[0] = before_;
    const Shown shown = row.take(x, count, line + 1, stripes + 4);
    // Pixels that may show something, once the stripe after them is known.
    const int32_t before = before_;
    int32_t from = max(before != 0 ? x - 1 : x - 1 + shown.begin, rows_.box.x0);
    int32_t to = x + 1 + shown.end;
    x += count;
    uint8_t* const last = stripes + 3 * count;
    if (x == end_) {
      to = min(to, rows_.box.x1);
      last[4] = 0;
    } else {
      to = min(to, x - 1);
    }
    auto* const kept = reinterpret_cast<uint8_t*>(&before_);
    for (int32_t i = 0; i < 4; ++i) {
      kept[i] = last[i];
    }
    const int32_t pixels = to - from;
    if (pixels > 0) {
      uint8_t* const rgb = last - 3 * (x - 1 - from);
      mix(rgb, pixels, is_red_first(lcd_.order));
      hand_on(sink_, lcd_, from, y_, rgb, pixels);
    }
  }

  const LcdRows& rows_;
  const LcdOptions& lcd_;
  const Sink& sink_;
  int32_t y_ = 0;
  int32_t end_ = 0;     // of the stripes that cover something
  int32_t before_ = 0;  // four stripes
};

// The same for stripes that lie on each other: channels take the place of the
// stripes of a row of pixels. Each has one of the row above `before`, which
// becomes its own last one.
__attribute__((noinline)) void mix_down(uint8_t* before,
                                        uint8_t* stripes,
                                        const uint8_t* below,
                                        int32_t count,
                                        bool red_first) noexcept {
  const uint32_t first = red_first ? 0 : 2;
  const uint32_t last = 2 - first;
  for (; count != 0; --count, stripes += 3, below += 3) {
    const int32_t two = stripes[0] + stripes[1];
    const int32_t middle = stripes[1];
    const uint8_t behind = stripes[2];
    const int32_t above = *before;
    const int32_t next = *below;
    *before++ = behind;
    stripes[first] = third(above + two);
    stripes[1] = third(two + behind);
    stripes[last] = third(middle + behind + next);
  }
}

// A column of pixels, at most kMost wide, row by row.
class StripeColumn {
 public:
  static constexpr int32_t kMost = 16;

  StripeColumn(const LcdRows& rows,
               const LcdOptions& lcd,
               const Sink& sink,
               int32_t x,
               int32_t count) noexcept
      : rows_(rows), lcd_(lcd), sink_(sink), x_(x), count_(count) {}

  __attribute__((noinline)) void draw(StripeRow& row) noexcept {
    const Rect& box = rows_.box;
    // What lies beside the box covers nothing, unless the window cuts it off.
    const int32_t first = box.y0 - (box.y0 != rows_.all.y0 ? 1 : 0);
    const int32_t end = box.y1 + (box.y1 != rows_.all.y1 ? 1 : 0);
    for (int32_t y = first; y < end; ++y) {
      draw_above(row, row.go_to(y, y == first), y);
    }
    if (end == box.y1) {
      draw_above(row, false, end);
    }
  }

 private:
  // The row above y; y is in the grid or covers nothing.
  __attribute__((noinline)) void draw_above(const StripeRow& row,
                                            bool is_in_grid,
                                            int32_t y) noexcept {
    int32_t line[3 * kMost];
    uint8_t* const stripes = stripes_[y & 1];
    uint8_t* const above = stripes_[~y & 1];
    Shown shown = kNothing;
    if (is_in_grid) {
      shown = row.take(x_, count_, line, stripes);
    } else {
      uint8_t* at = stripes;
      for (const uint8_t* const end = at + 3 * count_; at != end; ++at) {
        *at = 0;
      }
    }
    // What has shown nothing in three rows has left nothing, either.
    const Shown all = together(together(shown, last_), before_last_);
    before_last_ = last_;
    last_ = shown;
    const int32_t pixels = all.end - all.begin;
    if (pixels > 0) {
      uint8_t* const rgb = above + 3 * all.begin;
      mix_down(before_ + all.begin, rgb, stripes + 3 * all.begin, pixels,
               is_red_first(lcd_.order));
      if (y > rows_.box.y0) {
        hand_on(sink_, lcd_, x_ + all.begin, y - 1, rgb, pixels);
      }
    }
  }

  static constexpr Shown kNothing = {kMost, 0};
  static Shown together(const Shown& a, const Shown& b) noexcept {
    return {min(a.begin, b.begin), max(a.end, b.end)};
  }

  const LcdRows& rows_;
  const LcdOptions& lcd_;
  const Sink& sink_;
  int32_t x_;
  int32_t count_;
  Shown last_ = kNothing;  // of the rows above
  Shown before_last_ = kNothing;
  uint8_t before_[kMost] = {};
  uint8_t stripes_[2][3 * kMost] = {};  // of this row and of the one above
};

// Not inline, both: one need not pay for the other's stack.
__attribute__((noinline)) void draw_rows(StripeRow& row,
                                         const LcdRows& rows,
                                         const LcdOptions& lcd,
                                         const Sink& sink) noexcept {
  StripeRows(rows, lcd, sink).draw(row);
}

__attribute__((noinline)) void draw_columns(StripeRow& row,
                                            const LcdRows& rows,
                                            const LcdOptions& lcd,
                                            const Sink& sink) noexcept {
  const Rect& box = rows.box;
  for (int32_t x = box.x0; x < box.x1; x += StripeColumn::kMost) {
    StripeColumn(rows, lcd, sink, x, min(box.x1 - x, StripeColumn::kMost))
        .draw(row);
  }
}

}  // namespace

void draw_stripe_rows(const GlyphField& field,
                      const LcdRows& rows,
                      const LcdOptions& lcd,
                      const Sink& sink) noexcept {
  if (is_empty(rows.box)) {
    return;
  }
  const bool is_down = is_vertical(lcd.order);
  StripeRow row(field, rows, is_down);
  if (is_down) {
    draw_columns(row, rows, lcd, sink);
  } else {
    draw_rows(row, rows, lcd, sink);
  }
}

}  // namespace detail
}  // namespace inkcell
