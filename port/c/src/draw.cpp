// Text, runs and glyphs.
#include "inkcell/c/draw.h"
#include "inkcell/painter.hpp"

#include "mirror.hpp"

using namespace inkcell;
using c::code;
using c::cpp;
using c::point_of;
using c::text_of;
using c::workspace_of;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_text_measure_t> {
  using Type = TextMeasure;
};
}  // namespace c
}  // namespace inkcell

INKCELL_SAME_PLACE(inkcell_positioned_glyph_t, x, x);
INKCELL_SAME_PLACE(inkcell_positioned_glyph_t, y, y);
INKCELL_SAME_PLACE(inkcell_positioned_glyph_t, glyph, glyph);
INKCELL_SAME_PLACE(inkcell_positioned_glyph_t, offset, offset);
INKCELL_SAME_PLACE(inkcell_positioned_glyph_t, face, face);
INKCELL_SAME_PLACE(inkcell_face_t, font, font);
INKCELL_SAME_PLACE(inkcell_face_t, style, style);
INKCELL_SAME_PLACE(inkcell_text_measure_t, advance, advance);
INKCELL_SAME_PLACE(inkcell_text_measure_t, x_min, x_min);
INKCELL_SAME_PLACE(inkcell_text_measure_t, y_min, y_min);
INKCELL_SAME_PLACE(inkcell_text_measure_t, x_max, x_max);
INKCELL_SAME_PLACE(inkcell_text_measure_t, y_max, y_max);

void inkcell_draw_text(const inkcell_font_t* font,
                       const char* text,
                       size_t size,
                       const inkcell_style_t* style,
                       int32_t x_q6,
                       int32_t y_q6,
                       const inkcell_sink_t* sink,
                       const inkcell_workspace_t* ram) {
  Painter(*cpp(sink), workspace_of(ram))
      .text(*cpp(font), *cpp(style), point_of(x_q6, y_q6), text_of(text, size));
}

void inkcell_draw_glyph(const inkcell_font_t* font,
                        uint16_t glyph,
                        const inkcell_style_t* style,
                        int32_t x_q6,
                        int32_t y_q6,
                        const inkcell_sink_t* sink,
                        const inkcell_workspace_t* ram) {
  Painter(*cpp(sink), workspace_of(ram))
      .glyph(*cpp(font), *cpp(style), point_of(x_q6, y_q6), glyph);
}

void inkcell_draw_run(const inkcell_font_t* font,
                      const inkcell_positioned_glyph_t* glyphs,
                      size_t count,
                      const inkcell_style_t* style,
                      int32_t x_q6,
                      int32_t y_q6,
                      const inkcell_sink_t* sink,
                      const inkcell_workspace_t* ram) {
  Painter(*cpp(sink), workspace_of(ram))
      .glyphs(*cpp(font), *cpp(style), point_of(x_q6, y_q6),
              {cpp(glyphs), count});
}

void inkcell_draw_faces(const inkcell_face_t* face,
                        const inkcell_face_t* fallback,
                        size_t fallback_count,
                        const inkcell_positioned_glyph_t* glyphs,
                        size_t count,
                        int32_t x_q6,
                        int32_t y_q6,
                        const inkcell_sink_t* sink,
                        const inkcell_workspace_t* ram) {
  Painter(*cpp(sink), workspace_of(ram))
      .glyphs(*cpp(face), {cpp(fallback), fallback_count}, point_of(x_q6, y_q6),
              {cpp(glyphs), count});
}

void inkcell_glyph_box(const inkcell_font_t* font,
                       uint16_t glyph,
                       const inkcell_style_t* style,
                       int32_t x_q6,
                       int32_t y_q6,
                       inkcell_rect_t* out) {
  *cpp(out) =
      Painter().glyph_box(*cpp(font), *cpp(style), point_of(x_q6, y_q6), glyph);
}

inkcell_status_t inkcell_lay_out(const inkcell_font_t* font,
                                 const char* text,
                                 size_t size,
                                 const inkcell_style_t* style,
                                 inkcell_positioned_glyph_t* out,
                                 size_t capacity,
                                 size_t* count) {
  const Span<PositionedGlyph> room = {cpp(out), capacity};
  const Text line = text_of(text, size);
  Span<const PositionedGlyph> glyphs;
  const Status status =
      style == nullptr ? lay_out(*cpp(font), line, room, glyphs)
                       : lay_out(*cpp(font), line, *cpp(style), room, glyphs);
  *count = glyphs.size;
  return code(status);
}

void inkcell_measure(const inkcell_font_t* font,
                     const char* text,
                     size_t size,
                     const inkcell_style_t* style,
                     inkcell_text_measure_t* out) {
  const Text line = text_of(text, size);
  *cpp(out) = style == nullptr ? measure(*cpp(font), line)
                               : measure(*cpp(font), line, *cpp(style));
}

int32_t inkcell_to_px(const inkcell_font_t* font,
                      const inkcell_style_t* style,
                      int32_t units) {
  return to_px(*cpp(font), *cpp(style), units).raw;
}
