// A grid of quadtrees while it grows; build_sample_tree() is the way in.
#pragma once

#include <cstdint>
#include <vector>

#include "field/cell_test.hpp"
#include "field/sample_tree.hpp"
#include "shape/shape.hpp"
#include "target/grid.hpp"
#include "target/metric.hpp"

namespace inkcell::gen {

class Forest {
 public:
  /// `shape` must outlive the forest.
  Forest(const Shape& shape, const Target& options);

  /// Divides every tile until each cell passes or is of the smallest size.
  void grow();

  /// Divides cells until the field jumps nowhere by more than the tolerance
  /// where two of them meet. Does nothing for the fixed predicate.
  void mend_seams();

  /// The result, in the order that the format wants.
  SampleTree glyph() const;

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
  uint16_t write(uint32_t at, int level, SampleTree& glyph) const;
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

}  // namespace inkcell::gen
