// Fonts in ROM.
#include "inkcell/c/font.h"

#include "mirror.hpp"

using namespace inkcell;
using c::code;
using c::cpp;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_glyph_metrics_t> {
  using Type = GlyphMetrics;
};
template <>
struct CppOf<inkcell_font_metrics_t> {
  using Type = FontMetrics;
};
template <>
struct CppOf<inkcell_font_range_t> {
  using Type = FontRange;
};
}  // namespace c
}  // namespace inkcell

INKCELL_SAME_PLACE(inkcell_glyph_metrics_t, advance, advance);
INKCELL_SAME_PLACE(inkcell_glyph_metrics_t, x_min, x_min);
INKCELL_SAME_PLACE(inkcell_glyph_metrics_t, y_min, y_min);
INKCELL_SAME_PLACE(inkcell_glyph_metrics_t, x_max, x_max);
INKCELL_SAME_PLACE(inkcell_glyph_metrics_t, y_max, y_max);
INKCELL_SAME_PLACE(inkcell_font_metrics_t, units_per_em, units_per_em);
INKCELL_SAME_PLACE(inkcell_font_metrics_t, ascender, ascender);
INKCELL_SAME_PLACE(inkcell_font_metrics_t, descender, descender);
INKCELL_SAME_PLACE(inkcell_font_metrics_t, line_gap, line_gap);
INKCELL_SAME_PLACE(inkcell_font_metrics_t, x_height, x_height);
INKCELL_SAME_PLACE(inkcell_font_metrics_t, cap_height, cap_height);
INKCELL_SAME_PLACE(inkcell_font_metrics_t, x_min, x_min);
INKCELL_SAME_PLACE(inkcell_font_metrics_t, y_min, y_min);
INKCELL_SAME_PLACE(inkcell_font_metrics_t, x_max, x_max);
INKCELL_SAME_PLACE(inkcell_font_metrics_t, y_max, y_max);
INKCELL_SAME_PLACE(inkcell_font_range_t, min_px, min_px);
INKCELL_SAME_PLACE(inkcell_font_range_t, max_px, max_px);
INKCELL_SAME_PLACE(inkcell_font_range_t, band_u, band_u);
INKCELL_SAME_PLACE(inkcell_font_range_t, tolerance, tolerance);
INKCELL_SAME_PLACE(inkcell_font_range_t, max_cells, max_cells);
INKCELL_SAME_PLACE(inkcell_font_range_t, max_nodes, max_nodes);
INKCELL_SAME_PLACE(inkcell_font_range_t, max_depth, max_depth);

inkcell_status_t inkcell_font_open(const void* rom,
                                   size_t size,
                                   inkcell_font_t* out) {
  *cpp(out) = Font();
  return code(Font::open({static_cast<const uint8_t*>(rom), size}, *cpp(out)));
}

inkcell_status_t inkcell_font_verify(const inkcell_font_t* font) {
  return code(cpp(font)->verify());
}

uint16_t inkcell_font_glyph_count(const inkcell_font_t* font) {
  return cpp(font)->glyph_count();
}

bool inkcell_font_has_outlines(const inkcell_font_t* font) {
  return cpp(font)->has_outlines();
}

void inkcell_font_metrics(const inkcell_font_t* font,
                          inkcell_font_metrics_t* out) {
  *cpp(out) = cpp(font)->metrics();
}

void inkcell_font_range(const inkcell_font_t* font, inkcell_font_range_t* out) {
  *cpp(out) = cpp(font)->range();
}

inkcell_status_t inkcell_font_glyph(const inkcell_font_t* font,
                                    uint32_t code_point,
                                    uint16_t* out) {
  return code(cpp(font)->glyph_of(code_point, *out));
}

inkcell_status_t inkcell_font_glyph_metrics(const inkcell_font_t* font,
                                            uint16_t glyph,
                                            inkcell_glyph_metrics_t* out) {
  *cpp(out) = GlyphMetrics();
  return code(cpp(font)->glyph_metrics(glyph, *cpp(out)));
}

int32_t inkcell_font_advance(const inkcell_font_t* font, uint16_t glyph) {
  return cpp(font)->advance(glyph);
}

int32_t inkcell_font_kerning(const inkcell_font_t* font,
                             uint16_t left,
                             uint16_t right) {
  return cpp(font)->kerning(left, right);
}

const char* inkcell_font_name(const inkcell_font_t* font, size_t* size) {
  const Span<const char> name = cpp(font)->name();
  *size = name.size;
  return name.data;
}
