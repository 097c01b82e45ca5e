// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_lay_out_shaped(const inkcell_painter_t* painter,
                                        const inkcell_font_t* font,
                                        const inkcell_shaped_run_t* run,
                                        const inkcell_style_t* style,
                                        inkcell_positioned_glyph_t* out,
                                        size_t capacity,
                                        size_t* count) {
  Span<const PositionedGlyph> glyphs;
  const Status status = painter_of(painter).lay_out(ref(font), ref(style),
      ref(run), {cpp(out), capacity}, glyphs);
  *count = glyphs.size;
  return code(status);
}

void inkcell_measure_shaped(const inkcell_painter_t* painter,
                            const inkcell_font_t* font,
                            const inkcell_shaped_run_t* run,
                            const inkcell_style_t* style,
                            inkcell_pixel_measure_t* out) {
  ref(out) = painter_of(painter).measure(ref(font), ref(style), ref(run));
}

void inkcell_draw_shaped(const inkcell_painter_t* painter,
                         const inkcell_font_t* font,
                         const inkcell_shaped_run_t* run,
                         const inkcell_style_t* style,
                         int32_t x_q6,
                         int32_t y_q6) {
  painter_of(painter).text(ref(font), ref(style), point_of(x_q6, y_q6),
      ref(run));
}
