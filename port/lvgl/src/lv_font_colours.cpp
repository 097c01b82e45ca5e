// Glyphs of several colours. Apart, so that other fonts link none.
#include "inkcell/layers/colour_glyphs.hpp"

#include "font_state.hpp"

void inkcell_lv_font_set_colours(inkcell_lv_font_t* font) {
  using namespace inkcell;
  inkcell_lv_font_set_direct(font);
  port::state_of(*font).draw_colours =
      [](const Painter& painter, const CanvasColour& ink, const Font& from,
         const Style& style, Point origin, uint16_t glyph) {
        const ColourGlyphs colours(ink, &painter.drawer());
        painter.with(colours).glyph(from, style, origin, glyph);
      };
}
