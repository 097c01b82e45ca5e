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
        walk_(field, brush, detail::reach_of(brush.filter()) + kFlattest) {
    // Where the middle one is this far beyond the ramp, all are.
    const int32_t way = is_vertical(style.order) ? kWay : kWay / 2;
    empty_q10_ = filter_.outside_q10 - way;
    full_q10_ = filter_.inside_q10 + way;
  }

  // Of kCount stripes, 3 or 5, around `middle`; `ways` lead to them from there.
  template <uint32_t kCount>
  __attribute__((noinline)) void take(const FieldPosition& middle,
                                      const FieldPosition* ways,
                                      uint8_t* out) noexcept {
    constexpr uint32_t kMiddle = kCount / 2;
    const int32_t middle_q10 = walk_.distance_q10(middle);
    if (middle_q10 >= full_q10_ || middle_q10 <= empty_q10_) {
      for (uint32_t i = 0; i < kCount; ++i) {
        out[i] = middle_q10 >= full_q10_ ? 255 : 0;
      }
      return;
    }
    int32_t d[kCount];
    int32_t most_q10 = 0;  // of what changes from one to the next
    for (uint32_t i = 0; i < kCount; ++i) {
      d[i] = i == kMiddle ? middle_q10
                          : walk_.near_q10(detail::moved(middle, ways[i]));
      const int32_t change = i == 0 ? 0 : d[i] - d[i - 1];
      const int32_t size = change < 0 ? -change : change;
      most_q10 = size > most_q10 ? size : most_q10;
    }
    const int32_t part = (3 * most_q10 + 16) >> 5;
    const int32_t steepness = kSteepness[part < 32 ? part : 32];
    const int32_t centre = (filter_.outside_q10 + filter_.inside_q10) >> 1;
    for (uint32_t i = 0; i < kCount; ++i) {
      out[i] = filter_.coverage(centre + (((d[i] - centre) * steepness) >> 8));
    }
  }

 private:
  // Two stripes, and more where fitting stretches. [px, Q10]
  static constexpr int32_t kWay = 3 << 8;
  // What the flattest ramp of all reaches beyond the filter's. [px, Q22]
  static constexpr int32_t kFlattest = 1 << 18;

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
  __attribute__((noinline)) void put(int32_t x,
                                     const uint8_t* stripes) noexcept {
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

// What drawing takes, in frames of their own: none shall be large.
struct Rows {
  const Brush& brush;
  const FinePoint& origin;
  const RowMap* map;
  Rect box;

  __attribute__((noinline)) FieldPosition at(int32_t x,
                                             int32_t y,
                                             int32_t right_q10,
                                             int32_t up_q10) const noexcept {
    return detail::sample_position(brush, origin, map, x, y,
                                   {right_q10, up_q10});
  }
};

// From the middle of a pixel to its stripes, and to those beside it.
struct Ways {
  FieldPosition way[5];

  __attribute__((noinline))
  Ways(const Rows& rows, bool is_down, int32_t y) noexcept {
    const FieldPosition middle = rows.at(rows.box.x0, y, 0, 0);
    for (int32_t i = 0; i < 5; ++i) {
      const int32_t third = (i - 2) * kThird;
      const FieldPosition at = is_down ? rows.at(rows.box.x0, y, 0, -third)
                                       : rows.at(rows.box.x0, y, third, 0);
      way[i] = {at.x_q16 - middle.x_q16, at.y_q16 - middle.y_q16,
                at.x_q20 - middle.x_q20, at.y_q20 - middle.y_q20};
    }
  }
};

// A row of pixels whose stripes stand side by side. Only three a pixel are new:
//
//   | . . 0 | 1 2 3 | 4 5 6 |     1 2 3 are those of pixel x
//
__attribute__((noinline)) void draw_across(const Rows& rows,
                                           const Ways& ways,
                                           int32_t y,
                                           Stripes& stripes,
                                           RgbSpans& spans) noexcept {
  const FieldPosition step = detail::pixel_step(rows.brush);
  const FieldPosition* const three = ways.way + 1;
  FieldPosition at = rows.at(rows.box.x0 - 1, y, 0, 0);
  uint8_t covered[7];
  stripes.take<3>(at, three, covered + 1);
  at = detail::moved(at, step);
  stripes.take<3>(at, three, covered + 4);
  for (int32_t x = rows.box.x0; x < rows.box.x1; ++x) {
    for (int32_t i = 0; i < 4; ++i) {
      covered[i] = covered[i + 3];
    }
    at = detail::moved(at, step);
    stripes.take<3>(at, three, covered + 4);
    spans.put(x, covered);
  }
}

// The same for stripes that lie on each other.
__attribute__((noinline)) void draw_down(const Rows& rows,
                                         const Ways& ways,
                                         int32_t y,
                                         Stripes& stripes,
                                         RgbSpans& spans) noexcept {
  const FieldPosition step = detail::pixel_step(rows.brush);
  FieldPosition at = rows.at(rows.box.x0, y, 0, 0);
  uint8_t covered[5];
  for (int32_t x = rows.box.x0; x < rows.box.x1; ++x) {
    stripes.take<5>(at, ways.way, covered);
    spans.put(x, covered);
    at = detail::moved(at, step);
  }
}

// Rows that are fitted lie at ways of their own.
__attribute__((noinline)) void draw_fitted_down(const Rows& rows,
                                                int32_t y,
                                                Stripes& stripes,
                                                RgbSpans& spans) noexcept {
  const Ways ways(rows, true, y);
  draw_down(rows, ways, y, stripes, spans);
}

__attribute__((noinline)) void draw_rows(const Rows& rows,
                                         const Ways& ways,
                                         const LcdStyle& style,
                                         Stripes& stripes,
                                         const Sink& sink) noexcept {
  RgbSpans spans(sink, style, rows.box.y0);
  for (int32_t y = rows.box.y0; y < rows.box.y1; ++y) {
    if (!is_vertical(style.order)) {
      draw_across(rows, ways, y, stripes, spans);
    } else if (rows.map == nullptr) {
      draw_down(rows, ways, y, stripes, spans);
    } else {
      draw_fitted_down(rows, y, stripes, spans);
    }
    spans.next_row();
  }
}

__attribute__((noinline)) void draw_stripes(const Rows& rows,
                                            const LcdStyle& style,
                                            Stripes& stripes,
                                            const Sink& sink) noexcept {
  const Ways ways(rows, is_vertical(style.order), rows.box.y0);
  draw_rows(rows, ways, style, stripes, sink);
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
  draw_stripes({brush, origin, rows,
                detail::painted_box(field, brush, origin, rows, sink.window,
                                    across_q10, 2 * kThird - across_q10)},
               style, stripes, sink);
}

}  // namespace inkcell
