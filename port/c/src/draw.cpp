// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

void inkcell_text_report_init(inkcell_text_report_t* report) {
  ref(report) = TextReport();
}

void inkcell_draw_text(const inkcell_painter_t* painter,
                       const inkcell_font_t* font,
                       const char* text,
                       size_t size,
                       const inkcell_style_t* style,
                       int32_t x_q6,
                       int32_t y_q6) {
  painter_of(painter).text(ref(font), ref(style), point_of(x_q6, y_q6),
      text_of(text, size));
}

void inkcell_draw_glyph(const inkcell_painter_t* painter,
                        const inkcell_font_t* font,
                        uint16_t glyph,
                        const inkcell_style_t* style,
                        int32_t x_q6,
                        int32_t y_q6) {
  painter_of(painter).glyph(ref(font), ref(style), point_of(x_q6, y_q6), glyph);
}

void inkcell_draw_glyphs(const inkcell_painter_t* painter,
                         const inkcell_font_t* font,
                         const inkcell_positioned_glyph_t* glyphs,
                         size_t count,
                         const inkcell_style_t* style,
                         int32_t x_q6,
                         int32_t y_q6) {
  painter_of(painter).glyphs(ref(font), ref(style), point_of(x_q6, y_q6),
      {cpp(glyphs), count});
}

void inkcell_draw_faces(const inkcell_painter_t* painter,
                        const inkcell_face_t* face,
                        const inkcell_face_t* fallback,
                        size_t fallback_count,
                        const inkcell_positioned_glyph_t* glyphs,
                        size_t count,
                        int32_t x_q6,
                        int32_t y_q6) {
  painter_of(painter).glyphs(ref(face), {cpp(fallback), fallback_count},
      point_of(x_q6, y_q6), {cpp(glyphs), count});
}

void inkcell_glyph_box(const inkcell_painter_t* painter,
                       const inkcell_font_t* font,
                       uint16_t glyph,
                       const inkcell_style_t* style,
                       int32_t x_q6,
                       int32_t y_q6,
                       inkcell_rect_t* out) {
  ref(out) = painter_of(painter).glyph_box(ref(font), ref(style), point_of(x_q6,
      y_q6), glyph);
}

void inkcell_box(const inkcell_painter_t* painter,
                 const inkcell_font_t* font,
                 const char* text,
                 size_t size,
                 const inkcell_style_t* style,
                 int32_t x_q6,
                 int32_t y_q6,
                 inkcell_rect_t* out) {
  ref(out) = painter_of(painter).box(ref(font), ref(style), point_of(x_q6,
      y_q6), text_of(text, size));
}

void inkcell_bounding_box(const inkcell_rect_t* a,
                          const inkcell_rect_t* b,
                          inkcell_rect_t* out) {
  ref(out) = bounding_box(ref(a), ref(b));
}

inkcell_status_t inkcell_lay_out(const inkcell_painter_t* painter,
                                 const inkcell_font_t* font,
                                 const char* text,
                                 size_t size,
                                 const inkcell_style_t* style,
                                 inkcell_positioned_glyph_t* out,
                                 size_t capacity,
                                 size_t* count) {
  Span<const PositionedGlyph> glyphs;
  const Status status = painter_of(painter).lay_out(ref(font), ref(style),
      text_of(text, size), {cpp(out), capacity}, glyphs);
  *count = glyphs.size;
  return code(status);
}

void inkcell_measure(const inkcell_painter_t* painter,
                     const inkcell_font_t* font,
                     const char* text,
                     size_t size,
                     const inkcell_style_t* style,
                     inkcell_pixel_measure_t* out) {
  ref(out) = painter_of(painter).measure(ref(font), ref(style), text_of(text,
      size));
}

int32_t inkcell_to_px(const inkcell_font_t* font,
                      const inkcell_style_t* style,
                      int32_t units) {
  return to_px(ref(font), ref(style), units).raw;
}

inkcell_status_t inkcell_prepared_glyph_make(const inkcell_font_t* font,
                                             uint16_t glyph,
                                             const inkcell_style_t* style,
                                             int32_t x_q6,
                                             int32_t y_q6,
                                             const inkcell_workspace_t* ram,
                                             inkcell_prepared_glyph_t* out) {
  ref(out) = {};
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
