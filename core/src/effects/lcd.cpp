#include "inkcell/lcd.hpp"

#include "cells/cell_access.hpp"
#include "effects/lcd_stripes.hpp"
#include "place/painted_box.hpp"

namespace inkcell {
namespace {

using detail::FieldPosition;
using detail::is_vertical;
using detail::kFlattest;
using detail::kThird;
using detail::LcdRows;
using detail::PointWalk;
using detail::RgbSpans;

// What stripes cover, each for itself.
class Stripes {
 public:
  Stripes(const GlyphField& field,
          const TextStyle& style,
          const LcdOptions& lcd) noexcept
      : filter_(style.filter()),
        walk_(field,
              style,
              detail::reach_of(style.filter()) + (kFlattest << 12)) {
    // Where the middle one is this far beyond the ramp, all are.
    const int32_t way = is_vertical(lcd.order) ? kWay : kWay / 2;
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
    for (uint32_t i = 0; i < kCount; ++i) {
      d[i] = i == kMiddle ? middle_q10
                          : walk_.near_q10(detail::moved(middle, ways[i]));
    }
    detail::cover_stripes<kCount>(filter_, d, out);
  }

 private:
  // More than two stripes. [px, Q10]
  static constexpr int32_t kWay = 3 << 8;

  const Filter& filter_;
  PointWalk walk_;
  int32_t empty_q10_;
  int32_t full_q10_;
};

// From the middle of a pixel to its stripes, and to those beside it.
struct Ways {
  FieldPosition way[5];

  __attribute__((noinline))
  Ways(const LcdRows& rows, bool is_down) noexcept {
    const int32_t y = rows.box.y0;
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
__attribute__((noinline)) void draw_across(const LcdRows& rows,
                                           const Ways& ways,
                                           int32_t y,
                                           Stripes& stripes,
                                           RgbSpans& spans) noexcept {
  const FieldPosition step = detail::pixel_step(rows.style);
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
__attribute__((noinline)) void draw_down(const LcdRows& rows,
                                         const Ways& ways,
                                         int32_t y,
                                         Stripes& stripes,
                                         RgbSpans& spans) noexcept {
  const FieldPosition step = detail::pixel_step(rows.style);
  FieldPosition at = rows.at(rows.box.x0, y, 0, 0);
  uint8_t covered[5];
  for (int32_t x = rows.box.x0; x < rows.box.x1; ++x) {
    stripes.take<5>(at, ways.way, covered);
    spans.put(x, covered);
    at = detail::moved(at, step);
  }
}

__attribute__((noinline)) void draw_rows(const LcdRows& rows,
                                         const Ways& ways,
                                         const LcdOptions& lcd,
                                         Stripes& stripes,
                                         const Sink& sink) noexcept {
  RgbSpans spans(sink, lcd, rows.box.y0);
  for (int32_t y = rows.box.y0; y < rows.box.y1; ++y) {
    if (!is_vertical(lcd.order)) {
      draw_across(rows, ways, y, stripes, spans);
    } else {
      draw_down(rows, ways, y, stripes, spans);
    }
    spans.next_row();
  }
}

__attribute__((noinline)) void draw_stripes(const LcdRows& rows,
                                            const LcdOptions& lcd,
                                            Stripes& stripes,
                                            const Sink& sink) noexcept {
  const Ways ways(rows, is_vertical(lcd.order));
  draw_rows(rows, ways, lcd, stripes, sink);
}

// Point by point: of samples, or turned.
__attribute__((noinline)) void draw_points(const GlyphField& field,
                                           const LcdRows& rows,
                                           const LcdOptions& lcd,
                                           const Sink& sink) noexcept {
  Stripes stripes(field, rows.style, lcd);
  draw_stripes(rows, lcd, stripes, sink);
}

}  // namespace

void detail::paint_lcd(const GlyphField& field,
                       const TextStyle& style,
                       const void* options,
                       const FinePoint& origin,
                       const Sink& sink) {
  const LcdOptions& lcd = *static_cast<const LcdOptions*>(options);
  const int32_t across_q10 = is_vertical(lcd.order) ? 0 : 2 * kThird;
  constexpr int32_t kFar = 1 << 30;
  const Rect all =
      detail::painted_box(field, style, origin, {-kFar, -kFar, kFar, kFar},
                          across_q10, 2 * kThird - across_q10);
  const LcdRows lcd_rows = {style, origin, all, intersect(all, sink.window)};
  if (is_empty(lcd_rows.box)) {
    return;  // positions far away do not fit
  }
  if (style.is_upright() && detail::has_fields(field)) {
    detail::draw_stripe_rows(field, lcd_rows, lcd, sink);
  } else {
    draw_points(field, lcd_rows, lcd, sink);
  }
}

}  // namespace inkcell
