#include "page.hpp"

#include "display.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/layout/layout.hpp"
#include "inkcell/painter.hpp"
#include "page_scripts.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {
namespace {

// Articles 1 and 2 of the Universal Declaration of Human Rights, as far as they
// fit, and characters from everywhere in Unicode's first block of them.
constexpr const char* kTexts[kPages] = {
    u8"人人生而自由，在尊严和权利上一律平等。他们赋有理性和良心，"
    u8"并应以兄弟关系的精神相对待。",
    u8"人人有资格享有本宣言所载的一切权利和自由，不分种族、肤色、"
    u8"性别、语言、宗教、政治或其他见解、国籍。",
    u8"一丁乙亿佛凸凹匪厨叠吨噪园埠墨夔姊嬴孵寇岛嶙巢幢弊彝憋"
    u8"扑抉撼斋曙朽椿檬歌氮淆澜灶熨牍獠玺"};

// The size that fonts of outlines are drawn at. [px]
constexpr int32_t kOutlinePx = 12;

// A line has at most as many glyphs as pixels in a row.
PositionedGlyph room[kWidth];

alignas(4) uint8_t buffer[port::strip_bytes(kFormat, kWidth, kHeight)];

bool has_all(const Font& font, Text text) noexcept {
  while (text.size != 0) {
    uint16_t glyph = 0;
    if (font.glyph_of(next_code_point(text), glyph) != Status::ok) {
      return false;
    }
  }
  return true;
}

}  // namespace

Status show_page(const Font& font, uint32_t page) noexcept {
  // Lines of pixel fonts begin below their ascent, others on every 12th row.
  const bool has_outlines = font.has_outlines();
  const int32_t px = has_outlines ? kOutlinePx : font.range().min_px;
  const int32_t first =
      has_outlines ? px : font.metrics().ascender * px / font.units_per_em();
  Style style(Q26_6::from_int(px), has_outlines ? kFilterText : kFilterArea);
  Fit fit;
  if (has_outlines) {
    INKCELL_TRY(Fit::make(font, style, {}, fit));
    style.set_fit(fit);
  }
  const LayoutOptions options(font, style);
  const bool is_scripts = !has_outlines && page % (kPages + 1) == kPages;
  const Text text = is_scripts ? kScripts : kTexts[page % kPages];
  const Strip strip = {{buffer, sizeof buffer},
                       0,
                       0,
                       kWidth,
                       kHeight,
                       port::stride_bytes(kFormat, kWidth)};
  Canvas canvas(strip);
  const Painter painter(canvas.sink(Ink::text));
  const Q26_6 width = Q26_6::from_int(kWidth);
  bool is_whole = true;
  TextLine line;
  for (int32_t y = first;
       y <= kHeight && next_line(options, painter, text, width, line);
       y += px) {
    Span<const PositionedGlyph> glyphs;
    INKCELL_TRY(lay_out(options, painter, text, line, width, room, glyphs));
    painter.glyphs(font, style, {Q26_6::from_int(0), Q26_6::from_int(y)},
                   glyphs);
    is_whole = has_all(font, {text.data + line.begin, line.length}) && is_whole;
  }
  INKCELL_TRY(board::display_write(strip));
  return is_whole ? Status::ok : Status::no_glyph;
}

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
