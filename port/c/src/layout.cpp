// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

void inkcell_bidi_init(inkcell_bidi_t* bidi, uint16_t* cells, size_t count) {
  ref(bidi) = Bidi({cells, count});
}

void inkcell_bidi_forget(inkcell_bidi_t* bidi) {
  ref(bidi).forget();
}

void inkcell_layout_options_init(inkcell_layout_options_t* options,
                                 const inkcell_font_t* font,
                                 const inkcell_style_t* style) {
  ref(options) = LayoutOptions(ref(font), ref(style));
}

void inkcell_layout_options_set_bidi(inkcell_layout_options_t* options,
                                     inkcell_bidi_t* bidi) {
  ref(options).set_bidi(ref(bidi));
}

int32_t inkcell_line_height(const inkcell_layout_options_t* options) {
  return line_height(ref(options)).raw;
}

int32_t inkcell_baseline(const inkcell_layout_options_t* options) {
  return baseline(ref(options)).raw;
}

bool inkcell_next_line(const inkcell_layout_options_t* options,
                       const inkcell_painter_t* painter,
                       const char* text,
                       size_t size,
                       int32_t width_q6,
                       inkcell_text_line_t* line) {
  return next_line(ref(options), painter_of(painter), text_of(text, size),
      Q26_6::from_raw(width_q6), ref(line));
}

void inkcell_shorten(const inkcell_layout_options_t* options,
                     const inkcell_painter_t* painter,
                     const char* text,
                     size_t size,
                     int32_t width_q6,
                     inkcell_text_line_t* line) {
  shorten(ref(options), painter_of(painter), text_of(text, size),
      Q26_6::from_raw(width_q6), ref(line));
}

inkcell_status_t inkcell_lay_out_line(const inkcell_layout_options_t* options,
                                      const inkcell_painter_t* painter,
                                      const char* text,
                                      size_t size,
                                      const inkcell_text_line_t* line,
                                      int32_t width_q6,
                                      inkcell_positioned_glyph_t* out,
                                      size_t capacity,
                                      size_t* count) {
  Span<const PositionedGlyph> glyphs;
  const Status status = lay_out(ref(options), painter_of(painter), text_of(text,
      size), ref(line), Q26_6::from_raw(width_q6),
      {cpp(out), capacity}, glyphs);
  *count = glyphs.size;
  return code(status);
}
