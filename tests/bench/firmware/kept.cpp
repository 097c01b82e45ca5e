// Programs that are linked to see what they keep of the library, not run. Each
// opens a font and draws:
//
//   INKCELL_KEEP 0   upright glyphs of cells, 8-bit coverage
//                1   the same, and lines of text
//                2   the same, at any angle
//                3   the same, into every format
#include "inkcell/port/a8.hpp"
#include "inkcell/text.hpp"

#if INKCELL_KEEP >= 3
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

#if INKCELL_KEEP >= 2
Direction direction;

Status make_brush(Brush& brush) {
  return Brush::make(kMinSize, kFilterText, direction, brush);
}
#else
Status make_brush(Brush& brush) {
  return Brush::make(kMinSize, kFilterText, brush);
}
#endif

template <typename Target>
Status draw_into(const Font& font, const Brush& brush) {
  Target target;
  target.strip.pixels = {bytes, sizeof bytes};
  Sink sink;
  INKCELL_TRY(make_sink(target, sink));
#if INKCELL_KEEP == 0
  draw_glyph(font, bytes[0], brush, {}, sink);
#else
  draw_text(font, "text", brush, {}, sink);
#endif
  return Status::ok;
}

}  // namespace

int main(int, char**) {
  Font font;
  Brush brush;
  if (Font::open({bytes, sizeof bytes}, font) != Status::ok ||
      make_brush(brush) != Status::ok ||
      draw_into<port::A8Target>(font, brush) != Status::ok) {
    return 1;
  }
#if INKCELL_KEEP >= 3
  if (draw_into<port::Grey2Target>(font, brush) != Status::ok ||
      draw_into<port::Grey4Target>(font, brush) != Status::ok ||
      draw_into<port::Grey8Target>(font, brush) != Status::ok ||
      draw_into<port::MonoPagesTarget>(font, brush) != Status::ok ||
      draw_into<port::MonoRowsTarget>(font, brush) != Status::ok ||
      draw_into<port::Rgb565Target>(font, brush) != Status::ok ||
      draw_into<port::Rgb888Target>(font, brush) != Status::ok ||
      draw_into<port::Xrgb8888Target>(font, brush) != Status::ok) {
    return 1;
  }
#endif
  return 0;
}
