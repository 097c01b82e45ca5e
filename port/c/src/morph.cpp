// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_outline_morph_open(const inkcell_font_t* font,
                                            uint16_t from,
                                            uint16_t to,
                                            inkcell_outline_morph_t* out) {
  ref(out) = {};
  return code(motion::OutlineMorph::open(ref(font), from, to, ref(out)));
}

inkcell_status_t inkcell_outline_morph_open_master(
    const inkcell_font_t* font, uint16_t glyph, inkcell_outline_morph_t* out) {
  ref(out) = {};
  return code(motion::OutlineMorph::open_master(ref(font), glyph, ref(out)));
}

int32_t inkcell_outline_morph_advance(const inkcell_outline_morph_t* morph,
                                      const inkcell_style_t* style,
                                      int32_t progress_q16) {
  return ref(morph).advance(ref(style), Q16_16::from_raw(progress_q16)).raw;
}

size_t inkcell_outline_morph_workspace_bytes(const inkcell_font_t* font) {
  return motion::OutlineMorph::workspace_bytes(ref(font));
}

void inkcell_outline_morph_draw(const inkcell_outline_morph_t* morph,
                                const inkcell_painter_t* painter,
                                const inkcell_style_t* style,
                                int32_t x_q6,
                                int32_t y_q6,
                                int32_t progress_q16) {
  ref(morph).draw(painter_of(painter), ref(style), point_of(x_q6, y_q6),
      Q16_16::from_raw(progress_q16));
}

void inkcell_outline_morph_box(const inkcell_outline_morph_t* morph,
                               const inkcell_style_t* style,
                               int32_t x_q6,
                               int32_t y_q6,
                               int32_t progress_q16,
                               inkcell_rect_t* out) {
  ref(out) = ref(morph).box(ref(style), point_of(x_q6, y_q6),
      Q16_16::from_raw(progress_q16));
}

int32_t inkcell_ease_in_out(int32_t progress_q16) {
  return motion::ease(motion::kEaseInOut, Q16_16::from_raw(progress_q16)).raw;
}
