// The leaves of a glyph's quadtree.
#pragma once

#include <cstdint>
#include <vector>

#include "inkcell/field/glyph_field.hpp"

namespace inkcell::tools {

/// A leaf, from its lower left corner. [u]
struct LeafCell {
  int32_t x_u = 0;
  int32_t y_u = 0;
  int32_t side_u = 0;
  bool is_saturated = false;
};

/// Each leaf once; empty for a glyph without ink.
std::vector<LeafCell> leaf_cells(const GlyphField& field);

}  // namespace inkcell::tools
