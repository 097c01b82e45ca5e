// Lines that were shaped when the program was built.
#include "inkcell/c/shaped_run.h"

#include "inkcell/painter.hpp"
#include "inkcell/shaped_run.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::code;
using c::cpp;
using c::point_of;
using c::workspace_of;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_text_measure_t> {
  using Type = TextMeasure;
};
template <>
struct CppOf<inkcell_shaped_glyph_t> {
  using Type = ShapedGlyph;
};
template <>
struct CppOf<inkcell_shaped_run_t> {
  using Type = ShapedRun;
};
}  // namespace c
}  // namespace inkcell

INKCELL_SAME_PLACE(inkcell_shaped_glyph_t, glyph, glyph);
INKCELL_SAME_PLACE(inkcell_shaped_glyph_t, x, x);
INKCELL_SAME_PLACE(inkcell_shaped_glyph_t, y, y);
INKCELL_SAME_PLACE(inkcell_shaped_run_t, glyphs, glyphs.data);
INKCELL_SAME_PLACE(inkcell_shaped_run_t, count, glyphs.size);
INKCELL_SAME_PLACE(inkcell_shaped_run_t, advance, advance);

inkcell_status_t inkcell_lay_out_shaped(const inkcell_font_t* font,
                                        const inkcell_shaped_run_t* run,
                                        const inkcell_style_t* style,
                                        inkcell_positioned_glyph_t* out,
                                        size_t capacity,
                                        size_t* count) {
  Span<const PositionedGlyph> glyphs;
  const Span<PositionedGlyph> room = {cpp(out), capacity};
  const Status status = style == nullptr ? lay_out(*cpp(run), room, glyphs)
                                         : lay_out(*cpp(font), *cpp(run),
                                                   *cpp(style), room, glyphs);
  *count = glyphs.size;
  return code(status);
}

void inkcell_measure_shaped(const inkcell_font_t* font,
                            const inkcell_shaped_run_t* run,
                            const inkcell_style_t* style,
                            inkcell_text_measure_t* out) {
  *cpp(out) = style == nullptr ? measure(*cpp(font), *cpp(run))
                               : measure(*cpp(font), *cpp(run), *cpp(style));
}

void inkcell_draw_shaped(const inkcell_font_t* font,
                         const inkcell_shaped_run_t* run,
                         const inkcell_style_t* style,
                         int32_t x_q6,
                         int32_t y_q6,
                         const inkcell_sink_t* sink,
                         const inkcell_workspace_t* ram) {
  Painter(*cpp(sink), workspace_of(ram))
      .text(*cpp(font), *cpp(style), point_of(x_q6, y_q6), *cpp(run));
}
