// A glyph as typed cells: what the encoder finds and the writers write.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "edges/code.hpp"
#include "edges/model.hpp"
#include "target/grid.hpp"

namespace inkcell {
namespace gen {

/// One field of a leaf: one of an earlier leaf, or a new one.
struct PrimitiveUse {
  bool is_new = false;
  PrimitiveCode code;  // new
  uint16_t field = 0;  // index in EdgeTree::fields
};

/// A square of the forest. Nodes lie in depth-first order, tiles row by row
/// from below; a split is followed by its four quarters (child 2 * upper +
/// right).
struct TreeNode {
  enum class Kind : uint8_t { split, outside, inside, leaf };

  Kind kind = Kind::outside;
  uint8_t size_log2 = 0;
  int16_t x_u = 0;
  int16_t y_u = 0;
  Join join = Join::single;
  std::array<PrimitiveUse, 3> uses;  // primitive_count(join) of them
};

/// What stands for the size of the cell in the steps of shared fields.
inline int shared_log2(const Grid& grid) {
  int log2 = grid.tile_log2;
  while (std::max(grid.tiles_x, grid.tiles_y) > 1 << (log2 - grid.tile_log2)) {
    ++log2;
  }
  return log2;
}

struct EdgeTree {
  Grid grid;
  PrimitiveSteps steps;
  /// Fields that several rows of tiles use, in steps of the whole grid; they
  /// come first in `fields`.
  std::vector<PrimitiveCode> shared;
  std::vector<PrimitiveNumbers> fields;
  std::vector<TreeNode> nodes;
  int failures = 0;  // squares of the smallest size that no fields fit
};

}  // namespace gen
}  // namespace inkcell
