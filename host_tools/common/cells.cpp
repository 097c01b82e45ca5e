#include "cells.hpp"

#include "inkcell/field/cell.hpp"

namespace inkcell::tools {

std::vector<LeafCell> leaf_cells(const GlyphField& field) {
  std::vector<LeafCell> leaves;
  for (int32_t y = field.y0_u; y < field.y1_u(); ++y) {
    for (int32_t x = field.x0_u; x < field.x1_u();) {
      const Cell cell = locate(field, x, y);
      const int32_t side = 1 << cell.size_log2;
      if (cell.y0_u == y) {
        leaves.push_back({cell.x0_u, y, side, cell.is_saturated()});
      }
      x = cell.x0_u + side;
    }
  }
  return leaves;
}

}  // namespace inkcell::tools
