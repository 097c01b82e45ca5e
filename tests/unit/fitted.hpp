// What grid fitting makes of a glyph, for its tests.
#pragma once

#include "check.hpp"
#include "font_builder.hpp"
#include "hints_record.hpp"
#include "inkcell/fit.hpp"

namespace fitting {

using namespace inkcell;
using namespace font_builder;

inline constexpr int32_t kPx = 1 << 10;  // [Q10]

alignas(4) inline uint8_t rom[1600];

// A font of .notdef and a bar from 195 to 430 units to the right and 0 to 625
// up.
inline Font make_font(Span<const uint8_t> hints) {
  static constexpr CmapEntry kCmap[] = {{'A', 0, 1}};
  static constexpr GlyphSpec kGlyphs[] = {
      {600, {0, 0, 0, 0}, nullptr, nullptr},
      {600, {195, 0, 430, 625}, bar, nullptr}};
  FontSpec spec;
  spec.cmap = {kCmap, 1};
  spec.glyphs = {kGlyphs, 2};
  spec.hints = hints;
  const size_t size = build_font(spec, rom);
  CHECK(size != 0);
  Font font;
  CHECK_OK(Font::open({rom, size}, font));
  return font;
}

inline Font usual_font() {
  HintsRecord hints;
  hints.make_usual();
  return make_font(hints.write(2));
}

inline Brush brush_of(int32_t px_q6) {
  Brush brush;
  CHECK_OK(Brush::make(Q26_6::from_raw(px_q6), kFilterText, brush));
  return brush;
}

// What becomes of a glyph.
struct Fitted {
  FinePoint origin;
  RowMap rows;

  // Where the screen shows a height of the glyph in u. [px, Q10]
  int32_t screen_q10(int32_t u, const Brush& brush) const {
    const int32_t wanted = (u * brush.size().raw) >> 6;
    for (uint32_t i = 0; i < rows.count; ++i) {
      if (rows.knots[i].glyph_q10 == wanted) {
        return rows.knots[i].screen_q10;
      }
    }
    return INT32_MAX;
  }
};

inline Fitted fitted(const Font& font,
                     const Brush& brush,
                     const FitOptions& options,
                     FinePoint origin) {
  Fit fit;
  CHECK_OK(Fit::make(font, brush, options, fit));
  GlyphField field;
  field.glyph = 1;
  Fitted result;
  result.origin = origin;
  fit_glyph(field.glyph, brush, &fit, result.origin, result.rows);
  return result;
}

}  // namespace fitting
