// Programs that are linked to see what they keep of the library, not run. Each
// opens a font and draws:
//
//   INKCELL_KEEP 0   upright glyphs into 8-bit coverage, by distance
//                1   the same, by exact area
//                2   as 0, and lines of text
//                3   as 2, with any matrix
//                4   as 3, and by area, into every format
//
// INKCELL_KEEP_FIELDS: the font is one of fields, and not of outlines;
// INKCELL_KEEP_STRIKES: one of strikes alone, which are drawn by area.
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"

#if INKCELL_KEEP_FIELDS
#  include "inkcell/field/draw.hpp"
#endif

#if INKCELL_KEEP_STRIKES
#  include "inkcell/strike/strike.hpp"
#endif

#if INKCELL_KEEP >= 4
#  include "inkcell/port/grey2.hpp"
#  include "inkcell/port/grey4.hpp"
#  include "inkcell/port/grey8.hpp"
#  include "inkcell/port/mono_pages.hpp"
#  include "inkcell/port/mono_rows.hpp"
#  include "inkcell/port/rgb565.hpp"
#  include "inkcell/port/rgb888.hpp"
#  include "inkcell/port/xrgb8888.hpp"
#endif

using namespace inkcell;

namespace {

alignas(4) uint8_t bytes[64];
#if INKCELL_KEEP == 1
Style style(kMinSize, kFilterArea);
#else
Style style(kMinSize, kFilterText);
#endif

#if INKCELL_KEEP >= 3
Direction direction;
Matrix matrix;

void make_style() {
  style = Style(kMinSize, kFilterText, direction);
#  if INKCELL_KEEP >= 4
  style = Style(matrix, kFilterArea);
#  endif
  style = Style(matrix, kFilterText);
}
#endif

Status open(Font& font) {
#if INKCELL_KEEP_FIELDS
  return Font::open({bytes, sizeof bytes}, kFieldCoding, font);
#elif INKCELL_KEEP_STRIKES
  return Font::open({bytes, sizeof bytes}, kStrikeCoding, font);
#else
  return Font::open({bytes, sizeof bytes}, font);
#endif
}

template <typename Canvas>
Status draw_into(const Font& font) {
  Strip strip;
  strip.pixels = {bytes, sizeof bytes};
  const Canvas canvas(strip);
#if INKCELL_KEEP < 2
  Painter(canvas).glyph(font, style, {}, bytes[0]);
#else
  Painter(canvas).text(font, style, {}, "text");
#endif
  return canvas.status();
}

}  // namespace

int main(int, char**) {
#if INKCELL_KEEP >= 3
  make_style();
#endif
  Font font;
  if (open(font) != Status::ok ||
      draw_into<port::A8Canvas>(font) != Status::ok) {
    return 1;
  }
#if INKCELL_KEEP >= 4
  if (draw_into<port::Grey2Canvas>(font) != Status::ok ||
      draw_into<port::Grey4Canvas>(font) != Status::ok ||
      draw_into<port::Grey8Canvas>(font) != Status::ok ||
      draw_into<port::MonoPagesCanvas>(font) != Status::ok ||
      draw_into<port::MonoRowsCanvas>(font) != Status::ok ||
      draw_into<port::Rgb565Canvas>(font) != Status::ok ||
      draw_into<port::Rgb888Canvas>(font) != Status::ok ||
      draw_into<port::Xrgb8888Canvas>(font) != Status::ok) {
    return 1;
  }
#endif
  return 0;
}
