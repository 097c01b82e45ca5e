// Checks tables that glyphs are read from by their numbers.
#pragma once

#include <stdint.h>

#include "base/bit_table.hpp"
#include "base/bytes.hpp"
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
  const uint8_t* const header = metrics_table().data;
  const uint8_t* const bits = header + metrics::kColumnBits;
  uint32_t row_bits = 0;
  for (uint32_t i = 1; i < metrics::kColumns; ++i) {
    row_bits += bits[i];
  }
  metrics_row_bits_ = static_cast<uint16_t>(row_bits);
  return detail::bits_fit(
             metrics_table(), metrics::kBytes,
             bits[0] * detail::load_u16(header + metrics::kAdvances) +
                 row_bits * glyph_count_) &&
         detail::bits_fit(glyph_table(), glyphs::kBytes,
                          glyph_table().data[glyphs::kOffsetBits] *
                              (uint32_t{glyph_count_} + 1));
}

}  // namespace inkcell
