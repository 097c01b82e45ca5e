#include "layer_table.hpp"

#include "base/bit_table.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::detail {

namespace colr = format::layers;

// At most 2^16 rows of 5 bits modulo 2^5, and 2^24 colours: bits wrap, but no
// number is read outside of the section.
LayerTable::LayerTable(const Font& font, const StoredLayers* stored) noexcept
    : section_(font.section(format::section::kLayers)) {
  bytes = static_cast<uint32_t>(section_.size);
  if (stored != nullptr && stored->font->rom().data == font.rom().data) {
    stored_ = stored;
    bytes = stored->bytes;
  }
  if (bytes < colr::kBytes) {
    return;
  }
  glyphs = bits(8 * colr::kGlyphs, 16);
  colours = bits(8 * colr::kColours, 16);
  const uint32_t three = bits(8 * colr::kPalettes, 24);
  palettes = three & 255;
  glyph_bits = three >> 8 & 255;
  colour_bits = three >> 16;
  start_bits = bits(8 * colr::kStartBits, 8);
  first_bit_ = 8 * (colr::kBytes + colr::kColourBytes * colours * palettes);
}

uint32_t LayerTable::bits(uint32_t bit, uint32_t width) const noexcept {
  if (stored_ == nullptr) {
    return read_any_bits(section_, bit, width);
  }
  return width > format::bit_table::kMaxBits
             ? 0
             : stored_->word(*stored_->font, bit / 8) >> bit % 8 &
                   ~(~uint32_t{0} << width);
}

LayerTable::Range LayerTable::layers_of(uint16_t glyph) const noexcept {
  // Invariant: the row, if there is one, is at row <= i < end.
  uint32_t row = 0;
  for (uint32_t end = glyphs; row < end;) {
    const uint32_t middle = row + (end - row) / 2;
    if (glyph_at(middle) < glyph) {
      row = middle + 1;
    } else {
      end = middle;
    }
  }
  Range range;
  if (row < glyphs && glyph_at(row) == glyph) {
    range = {start_at(row), start_at(row + 1)};
    if (range.end - range.first > colr::kMaxLayers) {
      range.end = range.first;
    }
  }
  return range;
}

Layer LayerTable::layer(uint32_t number) const noexcept {
  const uint32_t bit =
      row_bit(glyphs + 1) + number * (glyph_bits + colour_bits);
  return {static_cast<uint16_t>(bits(bit, glyph_bits)),
          static_cast<uint16_t>(bits(bit + glyph_bits, colour_bits))};
}

LayerColour LayerTable::colour(uint32_t palette,
                               uint32_t number) const noexcept {
  LayerColour colour;
  if (palette >= palettes) {
    palette = palettes == 0 ? 0 : palettes - 1;
  }
  const uint32_t at =
      colr::kBytes + colr::kColourBytes * (palette * colours + number);
  if (at + colr::kColourBytes <= bytes) {
    const uint32_t channels = bits(8 * at, 24);
    colour = {static_cast<uint8_t>(channels),
              static_cast<uint8_t>(channels >> 8),
              static_cast<uint8_t>(channels >> 16),
              static_cast<uint8_t>(bits(8 * at + 24, 8))};
  }
  return colour;
}

}  // namespace inkcell::detail
