// Glyphs of samples and styles for tests of effects.
#pragma once

#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "inkcell/style.hpp"

namespace effect {

using namespace inkcell;

alignas(4) inline uint8_t glyph_bytes[1536];
// Too large for the stack of a small board.
inline font_builder::Record glyph_record;

/// What glyph_record holds.
inline GlyphField open_glyph() {
  GlyphField field;
  CHECK(glyph_record.size() <= sizeof(glyph_bytes));
  glyph_record.write(glyph_bytes);
  CHECK_OK(GlyphField::open({glyph_bytes, glyph_record.size()}, field));
  return field;
}

inline GlyphField field_of(font_builder::Shape shape) {
  glyph_record.reset();
  glyph_record.fill(shape);
  return open_glyph();
}

/// Upright, or down the triangle of sides 3, 4 and 5.
inline Style style_of(int32_t size_q6, bool is_turned) {
  Direction direction;
  direction.cosine.raw = is_turned ? 858993459 : 1 << 30;
  direction.sine.raw = is_turned ? -644245094 : 0;
  return Style(Q26_6::from_raw(size_q6), kFilterText, direction);
}

}  // namespace effect
