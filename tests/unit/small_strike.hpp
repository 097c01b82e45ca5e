// A font of strikes alone with a few letters of 8 px, of 1 bit.
#pragma once

#include "check.hpp"
#include "font_builder.hpp"
#include "strike_font.hpp"

namespace small_strike {

using namespace inkcell;
using strike_font::Values;

constexpr uint32_t kPx = 8;
// The glyphs: .notdef, A, B and C, and how far each is from the next one.
constexpr uint16_t kGlyphs = 4;
constexpr uint16_t kAdvance = 14;

// A picture for each glyph, 6 pixels wide.
inline void draw_glyph(uint16_t glyph, Values& values) {
  values.left = 0;
  values.top = -7;
  values.width = 6;
  values.height = 7;
  for (int32_t y = 0; y < 7; ++y) {
    for (int32_t x = 0; x < 6; ++x) {
      values.at[y][x] =
          x == 0 || x == 5 || y == 0 || (x + y + glyph) % (glyph + 1) == 0;
    }
  }
}

// A font of so many glyphs, without characters if that is .notdef alone.
inline size_t build(uint16_t glyphs, Span<uint8_t> out) {
  static font_builder::GlyphSpec specs[kGlyphs];
  for (font_builder::GlyphSpec& spec : specs) {
    spec = {};
    spec.advance = kAdvance;
  }
  static const font_builder::CmapEntry cmap[] = {{'A', kGlyphs - 2, 1}};
  font_builder::FontSpec spec;
  spec.units_per_em = 2 * kPx;
  spec.glyphs = {specs, glyphs};
  spec.cmap = {cmap, glyphs == 1 ? size_t{0} : size_t{1}};
  static strike_font::StrikeWriter<512> strikes;
  strikes.begin(1);
  strikes.add({kPx, 1, format::StrikeFit::source, 0, glyphs, 0, 0}, draw_glyph);
  const size_t size =
      strike_font::add_section(out, font_builder::build_font(spec, out),
                               format::section::kGlyphs, strikes.bytes());
  CHECK(size != 0);
  strike_font::set_alone({out.data, size}, kPx);
  return size;
}

}  // namespace small_strike
