// Glyphs of samples made of any bytes.
#pragma once

#include "font_builder.hpp"
#include "random.hpp"

/// A grid of four by four tiles up to 256 u wide: nodes, saturated leaves and
/// cells at random, some of which do not exist.
inline void make_any(font_builder::Record& record, Random& random) {
  record.reset();
  record.tile_log2 = static_cast<uint8_t>(random.below(9));
  record.x0_u = static_cast<int16_t>(random.between(-400, 100));
  record.y0_u = static_cast<int16_t>(random.between(-400, 100));
  record.reference_count = 16 + 4 * random.below(30);
  for (uint32_t i = 0; i < record.reference_count; ++i) {
    record.references[i] = static_cast<uint16_t>(random.below(34));
    if ((random.next() & 1) != 0) {
      record.references[i] |= inkcell::format::glyph::kCellFlag;
    }
  }
  record.cell_count = 30;
  for (uint32_t i = 0; i < record.cell_count; ++i) {
    for (uint8_t& byte : record.cells[i]) {
      byte = static_cast<uint8_t>(random.byte());
    }
  }
}
