// Both digits are drawn in a window with soft edges.
#include "inkcell/motion/digit_roll.hpp"

#include "inkcell/motion/fade.hpp"
#include "inkcell/motion/numbers.hpp"
#include "limits.hpp"

namespace inkcell::motion {
namespace {

constexpr int32_t kMostPx = 2048;  // of a cell, whatever the font says

}  // namespace

DigitCells measure_digits(const Font& font, const Style& style) noexcept {
  TextMeasure all;
  // Of twice the ink, from the middle of the advance: it is in a cell's middle.
  int32_t left = 0;
  int32_t right = 0;
  for (uint32_t i = 0; i < 10; ++i) {
    GlyphMetrics digit;
    // A digit that the font lacks is .notdef.
    static_cast<void>(font.glyph_metrics(font.glyph_or_notdef('0' + i), digit));
    all.advance = max(all.advance, digit.advance);
    all.y_min = min(all.y_min, digit.y_min);
    all.y_max = max(all.y_max, digit.y_max);
    left = min(left, 2 * digit.x_min - digit.advance);
    right = max(right, 2 * digit.x_max - digit.advance);
  }
  all.x_min = (all.advance + left) / 2;
  all.x_max = (all.advance + right) / 2;
  const PixelMeasure px = to_px(font, style, all);
  const int32_t room = (px.bottom.raw - px.top.raw) / 8;
  DigitCells cells;
  cells.width.raw = clamp(px.advance.raw, 0, kMostPx * 64);
  cells.top = clamp((px.top.raw - room - 63) >> 6, -kMostPx, 0);
  cells.bottom = clamp((px.bottom.raw + room + 63) >> 6, 1, kMostPx);
  cells.left = clamp(px.left.raw >> 6, -kMostPx, 0);
  cells.right = clamp((px.right.raw - px.advance.raw + 63) >> 6, 0, kMostPx);
  return cells;
}

Rect cells_box(const DigitCells& cells,
               Point at,
               int32_t first,
               int32_t last) noexcept {
  // A pixel of a filter beyond the ink.
  const auto x = [&](int32_t cell) {
    return (at.x.raw + cell * cells.width.raw) >> 6;
  };
  const int32_t y = at.y.raw >> 6;
  return {x(first) + cells.left - 1, y + cells.top, x(last) + cells.right + 2,
          y + cells.bottom + 1};
}

void draw_roll(const Painter& painter,
               const Face& face,
               const DigitCells& cells,
               Point at,
               const uint16_t (&digits)[2],
               Q16_16 part) noexcept {
  SoftWindow soft;
  soft.target = &painter.sink();
  soft.window = cells_box(cells, at, 0, 1);
  const int32_t pitch = cells.bottom - cells.top;
  // Within the room beside digits, so that none fades at rest.
  const int32_t edge = clamp(pitch / 12, 1, 255);
  soft.soft.top = soft.soft.bottom = static_cast<uint8_t>(edge);
  const Sink sink = make_sink(soft);
  if (is_empty(sink.window)) {
    return;
  }
  const Painter rolls = painter.with(sink).for_motion();
  // Up by a part of the pitch.
  const int32_t up = lerp(0, pitch * 64, part);
  for (int32_t i = 0; i < 2; ++i) {
    const uint16_t digit = digits[i];
    const int32_t down = i * pitch * 64 - up;
    if (digit != kBlank && abs(down) < pitch * 64) {
      const Font& font = *face.font;
      const Q26_6 width = to_px(font, *face.style, font.advance(digit));
      rolls.glyph(
          font, *face.style,
          {Q26_6::from_raw(at.x.raw + (cells.width.raw - width.raw) / 2),
           Q26_6::from_raw(at.y.raw + down)},
          digit);
    }
  }
}

}  // namespace inkcell::motion
