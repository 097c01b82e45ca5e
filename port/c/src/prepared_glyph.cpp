// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_prepared_glyph_make(const inkcell_font_t* font,
                                             uint16_t glyph,
                                             const inkcell_style_t* style,
                                             int32_t x_q6,
                                             int32_t y_q6,
                                             const inkcell_workspace_t* ram,
                                             inkcell_prepared_glyph_t* out) {
  ref(out) = PreparedGlyph();
  return code(PreparedGlyph::make(ref(font), glyph, ref(style), point_of(x_q6,
      y_q6), *cpp(ram), ref(out)));
}

void inkcell_prepared_glyph_box(const inkcell_prepared_glyph_t* prepared,
                                inkcell_rect_t* out) {
  ref(out) = ref(prepared).box();
}

void inkcell_prepared_glyph_draw(const inkcell_prepared_glyph_t* prepared,
                                 const inkcell_sink_t* sink) {
  ref(prepared).draw(ref(sink));
}
