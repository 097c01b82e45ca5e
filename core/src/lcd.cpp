#include "inkcell/lcd.hpp"

#include "painted_box.hpp"
#include "point_walk.hpp"

namespace inkcell {
namespace {

using detail::FieldPosition;
using detail::PointWalk;

constexpr int32_t kThird = (1 << 10) / 3;  // [px, Q10]

// How much steeper than the filter the ramp of a stripe is, by 1/32 of the
// gradient's component across the stripes: a stripe is a third of a pixel wide
// and a pixel long, and a straight edge of normal (n, m) takes a way of
// n / 3 + m to cover it. [Q8]
constexpr uint16_t kSteepness[33] = {
    256, 253, 251, 249, 248, 246, 245, 244, 243, 243, 243,
    243, 243, 244, 245, 246, 248, 250, 252, 255, 259, 263,
    268, 274, 281, 289, 300, 313, 330, 353, 388, 448, 768};

// The mean of three to within a level, without a division.
uint8_t mean(int32_t a, int32_t b, int32_t c) noexcept {
  return static_cast<uint8_t>(((a + b + c) * 171 + 85) >> 9);
}

bool is_vertical(SubPixels order) noexcept {
  return order == SubPixels::rgb_vertical || order == SubPixels::bgr_vertical;
}

// What stripes cover, each for itself.
class Stripes {
 public:
  Stripes(const GlyphField& field,
          const Brush& brush,
          const LcdStyle& style) noexcept
      : filter_(brush.filter()),
        walk_(field, brush, detail::reach_of(brush.filter()) + (kWay << 12)) {
    // Where the middle one is this far beyond the ramp, all are.
    const int32_t way = is_vertical(style.order) ? kWay : kWay / 2;
    empty_q10_ = filter_.outside_q10 - way;
    full_q10_ = filter_.inside_q10 + way;
  }

  // Of `count` stripes with their middles at `at`; 3 or 5.
  __attribute__((noinline)) void take(const FieldPosition* at,
                                      int32_t count,
                                      uint8_t* out) noexcept {
    int32_t d[5];
    const int32_t middle = count >> 1;
    d[middle] = walk_.distance_q10(at[middle]);
    if (d[middle] >= full_q10_ || d[middle] <= empty_q10_) {
      for (int32_t i = 0; i < count; ++i) {
        out[i] = d[middle] >= full_q10_ ? 255 : 0;
      }
      return;
    }
    int32_t most_q10 = 0;  // of what changes from one to the next
    for (int32_t i = 0; i < count; ++i) {
      if (i != middle) {
        d[i] = walk_.distance_q10(at[i]);
      }
    }
    for (int32_t i = 1; i < count; ++i) {
      const int32_t change = d[i] - d[i - 1];
      const int32_t size = change < 0 ? -change : change;
      most_q10 = size > most_q10 ? size : most_q10;
    }
    const int32_t part = (3 * most_q10 + 16) >> 5;
    const int32_t steepness = kSteepness[part < 32 ? part : 32];
    const int32_t centre = (filter_.outside_q10 + filter_.inside_q10) >> 1;
    for (int32_t i = 0; i < count; ++i) {
      out[i] = filter_.coverage(centre + (((d[i] - centre) * steepness) >> 8));
    }
  }

 private:
  // Two stripes, and more where fitting stretches. [px, Q10]
  static constexpr int32_t kWay = 3 << 8;

  const Filter& filter_;
  PointWalk walk_;
  int32_t empty_q10_;
  int32_t full_q10_;
};

// Pixels of three coverages on their way to a sink.
class RgbSpans {
 public:
  RgbSpans(const Sink& sink, const LcdStyle& style, int32_t y) noexcept
      : sink_(sink), style_(style), y_(y) {}

  // Five stripes around a pixel; the three in the middle are its own. Each
  // channel is the mean of its stripe and the two beside it.
  void put(int32_t x, const uint8_t* stripes) noexcept {
    const uint8_t first = mean(stripes[0], stripes[1], stripes[2]);
    const uint8_t second = mean(stripes[1], stripes[2], stripes[3]);
    const uint8_t third = mean(stripes[2], stripes[3], stripes[4]);
    if ((first | second | third) == 0) {
      flush();
      return;
    }
    if ((first & second & third) == 255) {
      solid(x);
      return;
    }
    if (solid_count_ != 0 || count_ == kMaxSpan) {
      flush();
    }
    x_ = count_ == 0 ? x : x_;
    const bool red_first = style_.order == SubPixels::rgb ||
                           style_.order == SubPixels::rgb_vertical;
    uint8_t* const rgb = buffer_ + 3 * count_++;
    rgb[0] = red_first ? first : third;
    rgb[1] = second;
    rgb[2] = red_first ? third : first;
    if (style_.colour != 255) {
      fade(rgb);
    }
  }

  // To the row below.
  void next_row() noexcept {
    flush();
    ++y_;
  }

 private:
  void solid(int32_t x) noexcept {
    if (count_ != 0) {
      flush();
    }
    x_ = solid_count_ == 0 ? x : x_;
    ++solid_count_;
  }

  void fade(uint8_t* rgb) const noexcept {
    const int32_t grey = mean(rgb[0], rgb[1], rgb[2]);
    for (int32_t i = 0; i < 3; ++i) {
      rgb[i] =
          static_cast<uint8_t>(grey + (rgb[i] - grey) * style_.colour / 255);
    }
  }

  void flush() noexcept {
    if (solid_count_ != 0) {
      sink_.solid(sink_.context, x_, y_, solid_count_);
    } else if (count_ != 0 && sink_.coverage_rgb != nullptr) {
      sink_.coverage_rgb(sink_.context, x_, y_, buffer_, count_);
    } else if (count_ != 0) {
      for (int32_t i = 0; i < count_; ++i) {
        const uint8_t* rgb = buffer_ + 3 * i;
        buffer_[i] = mean(rgb[0], rgb[1], rgb[2]);
      }
      sink_.coverage(sink_.context, x_, y_, buffer_, count_);
    }
    count_ = 0;
    solid_count_ = 0;
  }

  const Sink& sink_;
  const LcdStyle& style_;
  int32_t y_;
  int32_t x_ = 0;
  // At most one of the two is not 0.
  int32_t count_ = 0;
  int32_t solid_count_ = 0;
  uint8_t buffer_[3 * kMaxSpan];
};

void advance(FieldPosition* at,
             int32_t count,
             const FieldPosition& step) noexcept {
  for (int32_t i = 0; i < count; ++i) {
    at[i] = detail::moved(at[i], step);
  }
}

// What drawing takes, in frames of their own: none shall be large.
struct Rows {
  const Brush& brush;
  const FinePoint& origin;
  const RowMap* map;
  Rect box;

  FieldPosition at(int32_t x,
                   int32_t y,
                   int32_t right_q10,
                   int32_t up_q10) const noexcept {
    return detail::sample_position(brush, origin, map, x, y,
                                   {right_q10, up_q10});
  }
};

// A row of pixels whose stripes stand side by side. Only three a pixel are new:
//
//   | . . 0 | 1 2 3 | 4 5 6 |     1 2 3 are those of pixel x
//
__attribute__((noinline)) void draw_across(const Rows& rows,
                                           int32_t y,
                                           Stripes& stripes,
                                           RgbSpans& spans) noexcept {
  const FieldPosition step = detail::pixel_step(rows.brush);
  FieldPosition at[3];
  for (int32_t i = 0; i < 3; ++i) {
    at[i] = rows.at(rows.box.x0 - 1, y, (i - 1) * kThird, 0);
  }
  uint8_t covered[7];
  stripes.take(at, 3, covered + 1);
  advance(at, 3, step);
  stripes.take(at, 3, covered + 4);
  for (int32_t x = rows.box.x0; x < rows.box.x1; ++x) {
    for (int32_t i = 0; i < 4; ++i) {
      covered[i] = covered[i + 3];
    }
    advance(at, 3, step);
    stripes.take(at, 3, covered + 4);
    spans.put(x, covered);
  }
}

// The same for stripes that lie on each other.
__attribute__((noinline)) void draw_down(const Rows& rows,
                                         int32_t y,
                                         Stripes& stripes,
                                         RgbSpans& spans) noexcept {
  const FieldPosition step = detail::pixel_step(rows.brush);
  FieldPosition at[5];
  for (int32_t i = 0; i < 5; ++i) {
    at[i] = rows.at(rows.box.x0, y, 0, (2 - i) * kThird);
  }
  uint8_t covered[5];
  for (int32_t x = rows.box.x0; x < rows.box.x1; ++x) {
    stripes.take(at, 5, covered);
    spans.put(x, covered);
    advance(at, 5, step);
  }
}

__attribute__((noinline)) void draw_rows(const Rows& rows,
                                         const LcdStyle& style,
                                         Stripes& stripes,
                                         const Sink& sink) noexcept {
  RgbSpans spans(sink, style, rows.box.y0);
  for (int32_t y = rows.box.y0; y < rows.box.y1; ++y) {
    if (is_vertical(style.order)) {
      draw_down(rows, y, stripes, spans);
    } else {
      draw_across(rows, y, stripes, spans);
    }
    spans.next_row();
  }
}

}  // namespace

void paint_lcd(const GlyphField& field,
               const Brush& brush,
               const void* options,
               const FinePoint& origin,
               const RowMap* rows,
               const Sink& sink) {
  const LcdStyle& style = *static_cast<const LcdStyle*>(options);
  Stripes stripes(field, brush, style);
  const int32_t across_q10 = is_vertical(style.order) ? 0 : 2 * kThird;
  draw_rows({brush, origin, rows,
             detail::painted_box(field, brush, origin, rows, sink.window,
                                 across_q10, 2 * kThird - across_q10)},
            style, stripes, sink);
}

}  // namespace inkcell
