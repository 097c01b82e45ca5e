// Glyphs that are decoded once: of draw.h.
#include "inkcell/prepared_glyph.hpp"

#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_prepared_glyph_t> {
  using Type = PreparedGlyph;
};
}  // namespace c
}  // namespace inkcell

inkcell_status_t inkcell_prepared_glyph_make(const inkcell_font_t* font,
                                             uint16_t glyph,
                                             const inkcell_style_t* style,
                                             int32_t x_q6,
                                             int32_t y_q6,
                                             const inkcell_workspace_t* ram,
                                             inkcell_prepared_glyph_t* out) {
  *cpp(out) = PreparedGlyph();
  return c::code(PreparedGlyph::make(*cpp(font), glyph, *cpp(style),
                                     c::point_of(x_q6, y_q6), *cpp(ram),
                                     *cpp(out)));
}

void inkcell_prepared_glyph_box(const inkcell_prepared_glyph_t* prepared,
                                inkcell_rect_t* out) {
  *cpp(out) = cpp(prepared)->box();
}

void inkcell_prepared_glyph_draw(const inkcell_prepared_glyph_t* prepared,
                                 const inkcell_sink_t* sink) {
  cpp(prepared)->draw(*cpp(sink));
}
