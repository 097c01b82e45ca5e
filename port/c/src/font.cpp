// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_font_open(const void* rom,
                                   size_t size,
                                   inkcell_font_t* out) {
  ref(out) = {};
  return code(Font::open({static_cast<const uint8_t*>(rom), size}, ref(out)));
}

inkcell_status_t inkcell_font_open_field(const void* rom,
                                         size_t size,
                                         inkcell_font_t* out) {
  ref(out) = {};
  return code(Font::open({static_cast<const uint8_t*>(rom), size}, kFieldCoding,
      ref(out)));
}

inkcell_status_t inkcell_font_verify(const inkcell_font_t* font) {
  return code(ref(font).verify());
}

uint16_t inkcell_font_glyph_count(const inkcell_font_t* font) {
  return ref(font).glyph_count();
}

bool inkcell_font_has_outlines(const inkcell_font_t* font) {
  return ref(font).has_outlines();
}

void inkcell_font_metrics(const inkcell_font_t* font,
                          inkcell_font_metrics_t* out) {
  ref(out) = ref(font).metrics();
}

void inkcell_font_range(const inkcell_font_t* font, inkcell_font_range_t* out) {
  ref(out) = ref(font).range();
}

inkcell_status_t inkcell_font_glyph_of(const inkcell_font_t* font,
                                       uint32_t code_point,
                                       uint16_t* out) {
  return code(ref(font).glyph_of(code_point, *out));
}

inkcell_status_t inkcell_font_glyph_metrics(const inkcell_font_t* font,
                                            uint16_t glyph,
                                            inkcell_glyph_metrics_t* out) {
  ref(out) = {};
  return code(ref(font).glyph_metrics(glyph, ref(out)));
}

int32_t inkcell_font_advance(const inkcell_font_t* font, uint16_t glyph) {
  return ref(font).advance(glyph);
}

int32_t inkcell_font_kerning(const inkcell_font_t* font,
                             uint16_t left,
                             uint16_t right) {
  return ref(font).kerning(left, right);
}

const char* inkcell_font_name(const inkcell_font_t* font, size_t* size) {
  const Span<const char> name = ref(font).name();
  *size = name.size;
  return name.data;
}
