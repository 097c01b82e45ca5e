// Supersampling subdivision: from the exact distance of a shape to cells in
// ROM.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "inkcell/format/rom.hpp"
#include "shape/shape.hpp"
#include "target/target.hpp"

namespace inkcell::gen {

/// A cell as it lies in ROM: format::samples.
using SampleCell = std::array<uint8_t, format::samples::kBytes>;

/// The field of one glyph, in the terms of format::glyph.
struct SampleTree {
  int tile_log2 = 0;
  int x0_u = 0;  // lower left corner of the grid
  int y0_u = 0;
  int tiles_x = 0;  // both 0 if the shape is empty
  int tiles_y = 0;
  /// One for each tile, row by row from below, then four for each node.
  std::vector<uint16_t> references;
  /// In the order of their tiles, so that a tile row's cells lie together.
  std::vector<SampleCell> cells;
  /// Levels below the tiles.
  int depth = 0;
  /// Largest error that the test lattice met, and the mean over the area of
  /// all cells that are not saturated. size_aware: of rendered intensity, at
  /// the worst size of the range for each point [1/255]. fixed: of distance
  /// where the predicate looks [1/1024 em]. Measured with the device's
  /// evaluation of the quantised cells.
  double worst_error = 0;
  double mean_error = 0;
  /// False if a cell of the smallest size is beyond the tolerance.
  bool within_tolerance = true;

  int node_count() const {
    return (static_cast<int>(references.size()) - tiles_x * tiles_y) / 4;
  }
};

/// Samples `shape` as finely as `options` demand. The result depends on
/// nothing else; calls may run in parallel.
///
/// Throws GeometryError too_complex or too_large if it does not fit the format.
SampleTree build_sample_tree(const Shape& shape, const Target& options);

}  // namespace inkcell::gen
