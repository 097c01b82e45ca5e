// Section COLR: layers of glyphs and palettes, read in place or from storage.
#pragma once

#include <stdint.h>

#include "inkcell/canvas_colour.hpp"
#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/storage.hpp"

namespace inkcell::detail {

struct Layer {
  uint16_t glyph;
  uint16_t colour;  // from LayerTable::colours on: the text's own, less opaque
};

/// Safe on any bytes: what lies outside of the section is 0.
class LayerTable {
 public:
  /// Without the section it has no glyph. `stored` may be null, or of another
  /// font.
  LayerTable(const Font& font, const StoredLayers* stored) noexcept;

  /// The layers of a glyph, first to end - 1; none if there are too many.
  struct Range {
    uint32_t first = 0;
    uint32_t end = 0;
  };
  Range layers_of(uint16_t glyph) const noexcept;

  Layer layer(uint32_t number) const noexcept;

  /// A colour of a palette, or opaque black if there is none.
  LayerColour colour(uint32_t palette, uint32_t number) const noexcept;

  uint32_t bytes = 0;  // of the section
  uint32_t glyphs = 0;
  uint32_t colours = 0;  // of a palette
  uint32_t palettes = 0;
  uint32_t glyph_bits = 0;
  uint32_t colour_bits = 0;
  uint32_t start_bits = 0;

  /// The glyph of a row, and its first layer.
  uint32_t glyph_at(uint32_t row) const noexcept {
    return bits(row_bit(row), glyph_bits);
  }
  uint32_t start_at(uint32_t row) const noexcept {
    return bits(row_bit(row) + glyph_bits, start_bits);
  }

 private:
  uint32_t bits(uint32_t bit, uint32_t width) const noexcept;
  uint32_t row_bit(uint32_t row) const noexcept {
    return first_bit_ + row * (glyph_bits + start_bits);
  }

  Span<const uint8_t> section_;
  const StoredLayers* stored_ = nullptr;  // instead of these
  uint32_t first_bit_ = 0;
};

}  // namespace inkcell::detail
