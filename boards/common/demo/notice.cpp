#include "notice.hpp"

#include <fonts/notice_arabic.hpp>
#include <fonts/notice_devanagari.hpp>
#include <fonts/notice_hebrew.hpp>
#include <fonts/notice_latin.hpp>
#include <fonts/notice_thai.hpp>

#include "canvas.hpp"
#include "inkcell/layout/text_box.hpp"
#include "show.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {
namespace {

constexpr Span<const uint8_t> kRoms[] = {
    fonts::notice_latin, fonts::notice_arabic, fonts::notice_devanagari,
    fonts::notice_hebrew, fonts::notice_thai};
constexpr size_t kFonts = sizeof kRoms / sizeof kRoms[0];

// Arabic and Thai letters are small in their em.
constexpr Style kPlain(16_px);
constexpr Style kLarger(18_px);
constexpr const Style* kStyles[kFonts] = {&kPlain, &kLarger, &kPlain, &kPlain,
                                          &kLarger};

constexpr int32_t kMargin = 10;
constexpr int32_t kHigh = kHeight / static_cast<int32_t>(kMostNotices);

Font notice_font[kFonts];
Face faces[kFonts];
uint16_t levels[kMostNoticeBytes];
Bidi bidi(levels);
Span<const Notice> shown;
TextBox line;

// The part before the first tab; `rest` is behind it.
Text take_title(Text notice, Text& rest) noexcept {
  size_t size = 0;
  while (size < notice.size && notice.data[size] != '\t') {
    ++size;
  }
  const size_t next = size < notice.size ? size + 1 : size;
  rest = {notice.data + next, notice.size - next};
  return {notice.data, size};
}

Status draw_notices(void*, const Strip& strip) noexcept {
  Canvas canvas(strip);
  int32_t y = 0;
  for (const Notice& notice : shown) {
    Text text;
    const Text title = take_title(notice, text);
    line.rect = {kMargin, y + 2, kWidth - kMargin, y + 22};
    line.draw(title, Painter(canvas.sink(Ink::clock)));
    line.rect = {kMargin, y + 22, kWidth - kMargin, y + kHigh};
    line.draw(text, Painter(canvas.sink(Ink::text)));
    y += kHigh;
  }
  return Status::ok;
}

}  // namespace

Status open_notices() noexcept {
  for (size_t i = 0; i < kFonts; ++i) {
    INKCELL_TRY(Font::open(kRoms[i], notice_font[i]));
    faces[i] = {&notice_font[i], kStyles[i]};
  }
  return Status::ok;
}

Span<const Font> notice_fonts() noexcept {
  return notice_font;
}

void show_notices(Span<const Notice> notices, WordShaper& shaper) noexcept {
  LayoutOptions options(notice_font[0], kPlain);
  options.fallback = {faces + 1, kFonts - 1};
  options.ellipsis = Ellipsis::end;
  options.line_height = 22_px;
  options.set_bidi(bidi);
  options.set_shaper(shaper);
  line.options = options;
  shown = notices;
  show(draw_notices);
}

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
