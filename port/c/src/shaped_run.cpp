// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_lay_out_shaped(const inkcell_font_t* font,
                                        const inkcell_shaped_run_t* run,
                                        const inkcell_style_t* style,
                                        inkcell_positioned_glyph_t* out,
                                        size_t capacity,
                                        size_t* count) {
  Span<const PositionedGlyph> glyphs;
  const Span<PositionedGlyph> room = {cpp(out), capacity};
  const Status status = style == nullptr ? lay_out(ref(run), room, glyphs)
                                         : lay_out(ref(font), ref(run),
      ref(style), room, glyphs);
  *count = glyphs.size;
  return code(status);
}

void inkcell_measure_shaped(const inkcell_font_t* font,
                            const inkcell_shaped_run_t* run,
                            const inkcell_style_t* style,
                            inkcell_text_measure_t* out) {
  ref(out) = style == nullptr ? measure(ref(font), ref(run)) :
      measure(ref(font), ref(run), ref(style));
}

void inkcell_draw_shaped(const inkcell_font_t* font,
                         const inkcell_shaped_run_t* run,
                         const inkcell_style_t* style,
                         int32_t x_q6,
                         int32_t y_q6,
                         const inkcell_sink_t* sink,
                         const inkcell_workspace_t* ram) {
  Painter(ref(sink), workspace_of(ram)).text(ref(font), ref(style),
      point_of(x_q6, y_q6), ref(run));
}
