// From the exact distance of a shape to typed cells.
//
// Top down: a square becomes a leaf if some combination of up to three fields,
// known ones or new ones fitted to the border here, keeps the limit at all of
// its test points, and if its four quarters together would not be cheaper.
// bit_costs.hpp says what choices cost, and errors cost some too. In the end
// the numbers of the fields are moved to where all their cells are truest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "edges/candidates.hpp"
#include "edges/leaf.hpp"
#include "edges/points.hpp"
#include "edges/tree.hpp"
#include "shape/shape.hpp"
#include "target/target.hpp"

namespace inkcell {
namespace gen {

class EdgeEncoder {
 public:
  /// `shape` must not be empty, and outlive the encoder.
  ///
  /// Throws GeometryError::too_large.
  EdgeEncoder(const Shape& shape, const Target& options);

  /// Where the device was found to miss the tolerance: look there too.
  void add_point(const Point& point) { points_.add_extra(point); }

  /// Throws GeometryError::too_complex if no record could hold the glyph.
  EdgeTree encode();

  /// Places where `tree` misses the tolerance, found on a finer lattice than
  /// its leaves were tested on; at most one for each leaf.
  std::vector<Point> find_misses(const EdgeTree& tree);

 private:
  // Numbers of fields, most recent first.
  using List = std::vector<uint16_t>;

  // A square and all below it. New fields are numbered after those that were
  // there before.
  struct Coded {
    std::vector<TreeNode> nodes;
    std::vector<PrimitiveNumbers> fields;
    List list;        // afterwards
    double cost = 0;  // with what errors are worth [bits]
    int failures = 0;
  };

  EdgeTree encode_rows(bool borrow);
  bool find_miss(const EdgeTree& tree, const TreeNode& leaf, Point& out);
  void share(EdgeTree tree);
  bool drop_unshared(const EdgeTree& tree);
  PrimitiveCode shared_code(const PrimitiveNumbers& field) const;
  PrimitiveNumbers shared_field(const PrimitiveCode& code) const;
  Coded encode_square(
      int x_u, int y_u, int log2, const List& list, double budget);
  bool divide(
      int x_u, int y_u, int log2, const List& list, double budget, Coded& out);
  Coded settle(
      const Leaf& leaf, int x_u, int y_u, int log2, const List& list) const;
  TreeNode node(TreeNode::Kind kind, int x_u, int y_u, int log2) const;

  Grid grid_;
  int fine_step_u_;
  PrimitiveSteps steps_;
  PointSource points_;
  CandidateSource candidates_;
  LeafSearch search_;
  int shared_log2_;
  int shared_x_u_;
  int shared_y_u_;
  std::vector<PrimitiveCode> shared_;
  std::vector<PrimitiveNumbers> fields_;  // of all that is decided so far
  uint32_t sure_splits_ = 0;          // squares that no leaf can replace
};

}  // namespace gen
}  // namespace inkcell
