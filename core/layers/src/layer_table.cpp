#include "layer_table.hpp"

#include "base/bytes.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::detail {

namespace colr = format::layers;

// At most 2^16 rows of 5 bits modulo 2^5, and 2^24 colours: bits wrap, but no
// number is read outside of the section.
LayerTable::LayerTable(const Font& font) noexcept
    : bytes(font.section(format::section::kLayers)) {
  if (bytes.size < colr::kBytes) {
    return;
  }
  const uint8_t* const at = bytes.data;
  glyphs = load_u16(at + colr::kGlyphs);
  colours = load_u16(at + colr::kColours);
  palettes = at[colr::kPalettes];
  glyph_bits = at[colr::kGlyphBits];
  colour_bits = at[colr::kColourBits];
  start_bits = at[colr::kStartBits];
  first_bit_ = 8 * (colr::kBytes + colr::kColourBytes * colours * palettes);
}

LayerTable::Range LayerTable::layers_of(uint16_t glyph) const noexcept {
  const BitTable table = rows();
  const uint32_t row = table.find(0, glyphs, glyph_bits, glyph);
  Range range;
  if (row != BitTable::kAbsent) {
    range.first = table.get(row, glyph_bits, start_bits);
    range.end = table.get(row + 1, glyph_bits, start_bits);
    if (range.end - range.first > colr::kMaxLayers) {
      range.end = range.first;
    }
  }
  return range;
}

Layer LayerTable::layer(uint32_t number) const noexcept {
  const uint32_t bit = layers_bit() + number * (glyph_bits + colour_bits);
  return {
      static_cast<uint16_t>(read_any_bits(bytes, bit, glyph_bits)),
      static_cast<uint16_t>(
          read_any_bits(bytes, bit + glyph_bits, colour_bits)),
  };
}

LayerColour LayerTable::colour(uint32_t palette,
                               uint32_t number) const noexcept {
  LayerColour colour;
  if (palette >= palettes) {
    palette = palettes == 0 ? 0 : palettes - 1;
  }
  const uint32_t at =
      colr::kBytes + colr::kColourBytes * (palette * colours + number);
  if (at + colr::kColourBytes <= bytes.size) {
    const uint8_t* const from = bytes.data + at;
    colour = {from[0], from[1], from[2], from[3]};
  }
  return colour;
}

}  // namespace inkcell::detail
