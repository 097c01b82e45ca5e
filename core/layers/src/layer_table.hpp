// Section COLR: layers of glyphs and palettes, read in place.
#pragma once

#include <stdint.h>

#include "base/bit_table.hpp"
#include "inkcell/canvas_colour.hpp"
#include "inkcell/font.hpp"
#include "inkcell/span.hpp"

namespace inkcell::detail {

struct Layer {
  uint16_t glyph;
  uint16_t colour;  // from LayerTable::colours on: the text's own, less opaque
};

/// Safe on any bytes: what lies outside of the section is 0.
class LayerTable {
 public:
  /// Without the section it has no glyph.
  explicit LayerTable(const Font& font) noexcept;

  /// The layers of a glyph, first to end - 1; none if there are too many.
  struct Range {
    uint32_t first = 0;
    uint32_t end = 0;
  };
  Range layers_of(uint16_t glyph) const noexcept;

  Layer layer(uint32_t number) const noexcept;

  /// A colour of a palette, or opaque black if there is none.
  LayerColour colour(uint32_t palette, uint32_t number) const noexcept;

  Span<const uint8_t> bytes;
  uint32_t glyphs = 0;
  uint32_t colours = 0;  // of a palette
  uint32_t palettes = 0;
  uint32_t glyph_bits = 0;
  uint32_t colour_bits = 0;
  uint32_t start_bits = 0;

  /// The rows of glyphs, and the bit at which layers begin.
  BitTable rows() const noexcept {
    return {&bytes, first_bit_, glyph_bits + start_bits};
  }
  uint32_t layers_bit() const noexcept {
    return first_bit_ + (glyphs + 1) * (glyph_bits + start_bits);
  }

 private:
  uint32_t first_bit_ = 0;
};

}  // namespace inkcell::detail
