#include "pipeline/preview.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include "inkcell/filter.hpp"
#include "inkcell/font.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"
#include "judge/canvas.hpp"
#include "judge/strike_pictures.hpp"

namespace inkcell::gen {
namespace {

constexpr int kColumns = 12;
constexpr double kLargestPx = 48;
constexpr int kCellWidth = 80;  // [px]
constexpr int kCellHeight = 104;
constexpr int kLeft = 12;      // of the glyph's origin in its cell
constexpr int kBaseline = 58;  // down from the top of the cell
constexpr int kLabels = 76;    // the first line of numbers
constexpr int kLine = 13;
constexpr int kScale = 2;  // of digits of 3 x 5 dots

// Digits and a point: five rows of three dots, the top left one highest.
constexpr uint16_t kDigits[] = {075557, 026227, 071747, 071717, 055711, 074717,
                                074757, 071111, 075757, 075717, 000002};

void draw_number(const std::string& text, int left, int top, Preview& out) {
  for (const char c : text) {
    const uint16_t dots = kDigits[c == '.' ? 10 : c - '0'];
    for (int y = 0; y < 5 * kScale; ++y) {
      for (int x = 0; x < 3 * kScale; ++x) {
        const int bit = 14 - (y / kScale * 3 + x / kScale);
        if ((dots >> bit & 1) != 0) {
          out.pixels[static_cast<size_t>(top + y) *
                         static_cast<size_t>(out.width) +
                     static_cast<size_t>(left + x)] = 96;
        }
      }
    }
    left += 4 * kScale;
  }
}

// The part of a glyph that lies in the cell whose top left corner is named.
void draw_cell(const Font& font,
               uint16_t glyph,
               const Style& style,
               int left,
               int top,
               Preview& out) {
  Canvas canvas(Rect{left, top, left + kCellWidth, top + kLabels - 2});
  Painter(canvas.sink())
      .glyph(font, style,
             {Q26_6::from_int(left + kLeft), Q26_6::from_int(top + kBaseline)},
             glyph);
  const Rect& area = canvas.area();
  for (int y = area.y0; y < area.y1; ++y) {
    for (int x = area.x0; x < area.x1; ++x) {
      out.pixels[static_cast<size_t>(y) * static_cast<size_t>(out.width) +
                 static_cast<size_t>(x)] =
          static_cast<uint8_t>(255 - canvas.at(x, y));
    }
  }
}

}  // namespace

Preview draw_preview(const RomFont& rom) {
  Font font;
  const int px =
      static_cast<int>(std::min(kLargestPx, rom.report.options.max_px));
  const bool is_strike = rom.report.options.coding == Coding::strike;
  const Style style(Q26_6::from_int(px), is_strike ? kFilterArea : kFilterText);
  if (open_font(rom.bytes, font) != Status::ok) {
    throw Error("the preview cannot be drawn: the device cannot read the font");
  }
  const auto& glyphs = rom.report.glyphs;
  const int count = static_cast<int>(glyphs.size());
  Preview out;
  out.width = std::min(count, kColumns) * kCellWidth;
  out.height = (count + kColumns - 1) / kColumns * kCellHeight;
  out.pixels.assign(
      static_cast<size_t>(out.width) * static_cast<size_t>(out.height), 255);
  for (int i = 0; i < count; ++i) {
    const int left = i % kColumns * kCellWidth;
    const int top = i / kColumns * kCellHeight;
    const GlyphReport& glyph = glyphs[static_cast<size_t>(i)];
    draw_cell(font, static_cast<uint16_t>(i), style, left, top, out);
    char error[16];
    std::snprintf(error, sizeof error, "%.1f",
                  std::min(glyph.worst_error, 9999.0));
    draw_number(std::to_string(glyph.bytes), left + kLeft, top + kLabels, out);
    draw_number(error, left + kLeft, top + kLabels + kLine, out);
  }
  return out;
}

}  // namespace inkcell::gen
