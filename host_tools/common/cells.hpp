// The leaves of a glyph's quadtree.
#pragma once

#include <cstdint>

#include "inkcell/field/cell.hpp"

namespace inkcell::tools {

/// Calls visit(cell) for each leaf of a field once, from below, from the left.
template <typename Visit>
void for_each_cell(const GlyphField& field, const Visit& visit) {
  for (int32_t y = field.y0_u; y < field.y1_u(); ++y) {
    for (int32_t x = field.x0_u; x < field.x1_u();) {
      const Cell cell = locate(field, x, y);
      if (cell.y0_u == y) {
        visit(cell);
      }
      x = cell.x0_u + (1 << cell.size_log2);
    }
  }
}

}  // namespace inkcell::tools
