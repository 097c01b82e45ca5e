// Checks tables that glyphs are read from by their numbers.
#pragma once

#include <stdint.h>

#include "base/bit_table.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {

// Whether METR and the offsets of GLYF have the size that glyph_count and their
// widths demand.
inline bool Font::fit_tables() noexcept {
  namespace metrics = format::metrics;
  namespace glyphs = format::glyphs;
  if (glyph_count_ == 0 || metrics_table().size < metrics::kBytes ||
      glyph_table().size < glyphs::kBytes) {
    return false;
  }
  uint32_t row_bits = 0;
  for (uint32_t i = 0; i < metrics::kColumns; ++i) {
    row_bits += metrics_table().data[metrics::kColumnBits + i];
  }
  metrics_row_bits_ = static_cast<uint16_t>(row_bits);
  return detail::bits_fit(metrics_table(), metrics::kBytes,
                          row_bits * glyph_count_) &&
         detail::bits_fit(glyph_table(), glyphs::kBytes,
                          glyph_table().data[glyphs::kOffsetBits] *
                              (uint32_t{glyph_count_} + 1));
}

}  // namespace inkcell
