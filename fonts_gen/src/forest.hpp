// A grid of quadtrees while it grows; build_adf() is the way in.
#pragma once

#include <cstdint>
#include <vector>

#include "adf.hpp"
#include "cell_test.hpp"
#include "metric.hpp"
#include "shape.hpp"

namespace inkcell {
namespace gen {

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
Grid lay_grid(const Shape& shape, const AdfOptions& options);

/// The tiles of a grid, row by row from below.
std::vector<CellSquare> tiles_of(const Grid& grid);

class Forest {
 public:
  /// `shape` must outlive the forest.
  Forest(const Shape& shape, const AdfOptions& options);

  /// Divides every tile until each cell passes or is of the smallest size.
  void grow();

  /// Divides cells until the field jumps nowhere by more than the tolerance
  /// where two of them meet. Does nothing for the fixed predicate.
  void mend_seams();

  /// The result, in the order that the format wants.
  AdfGlyph glyph() const;

 private:
  enum class Kind : uint8_t { outside, inside, cell, node };

  struct Tree {
    CellSquare square;
    Kind kind = Kind::outside;
    uint32_t children = 0;  // index of the first of four
    SampleCell cell{};
    Verdict verdict;
    bool tested = false;
  };

  void grow(uint32_t at, const Neighbourhood& truth, Lattice lattice);
  void divide(uint32_t at, const Neighbourhood& truth, const Lattice& lattice);
  bool settle(Tree& tree, const Neighbourhood& truth, Lattice& lattice) const;
  uint32_t leaf_at(int x_u, int y_u) const;
  double read(const Tree& leaf, double x_u, double y_u) const;
  double jump(const Tree& a, const Tree& b, int side) const;
  uint32_t weaker_at_seam(uint32_t at, int side) const;
  uint16_t write(uint32_t at, int level, AdfGlyph& glyph) const;
  double mean_error() const;

  const Shape& shape_;
  Metric metric_;
  CellTest test_;
  Grid grid_;
  bool size_aware_;
  int fit_rounds_;  // 0: cells are not fitted
  std::vector<Tree> trees_;
  uint32_t cell_count_ = 0;
};

}  // namespace gen
}  // namespace inkcell
