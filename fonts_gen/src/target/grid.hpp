// The squares that a glyph is divided into.
#pragma once

#include <vector>

#include "shape/neighbourhood.hpp"
#include "shape/shape.hpp"
#include "target/target.hpp"

namespace inkcell::gen {

/// A square of the quadtree, 2^size_log2 u wide.
struct CellSquare {
  int x_u = 0;
  int y_u = 0;
  int size_log2 = 0;

  int size_u() const { return 1 << size_log2; }
  Square square() const {
    return {static_cast<double>(x_u), static_cast<double>(y_u),
            static_cast<double>(size_u())};
  }
  /// Children 0..3 are lower left, lower right, upper left, upper right.
  CellSquare child(int index) const {
    const int half = size_u() / 2;
    return {x_u + (index & 1) * half, y_u + (index >> 1) * half, size_log2 - 1};
  }
};

/// Where the tiles of a glyph lie.
struct Grid {
  int tile_log2 = 0;
  int x0_u = 0;
  int y0_u = 0;
  int tiles_x = 0;
  int tiles_y = 0;
};

/// The grid for `shape`, which is not empty. size_aware: tiles of 256 u over
/// the ink and the band, slack on all sides alike. fixed: one tile of
/// 64 * 2^k u, its corner at the ink's and the band's.
///
/// Throws GeometryError::too_large.
Grid lay_grid(const Shape& shape, const Target& options);

/// The tiles of a grid, row by row from below.
std::vector<CellSquare> tiles_of(const Grid& grid);

}  // namespace inkcell::gen
