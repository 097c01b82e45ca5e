// The exact distance of a shape on a lattice of whole u, with what it is the
// distance to: the encoder of typed cells asks for the same points again and
// again.
#pragma once

#include <cstdint>
#include <vector>

#include "shape/shape.hpp"

namespace inkcell {
namespace gen {

/// A maximal stretch of the border without corners.
struct BorderChain {
  uint32_t first_edge = 0;
  uint32_t edge_count = 0;
};

/// A place where two chains meet.
struct Corner {
  Point at;
  int16_t before = -1;  // chains
  int16_t after = -1;
  uint32_t edge_before = 0;  // that ends here
  uint32_t edge_after = 0;   // that begins here
};

/// The distance at a point, and what is nearest there.
struct TruthSample {
  float distance_u = 0;  // positive inside
  int16_t chain = -1;
  int16_t corner = -1;  // -1: the nearest point is not a corner
};

/// Not for use by several threads at once.
class DistanceLattice {
 public:
  /// Answers in x0..x0 + width, y0..y0 + height. [u] `shape` must outlive it.
  ///
  /// Throws GeometryError::too_complex above 32767 edges.
  DistanceLattice(
      const Shape& shape, int x0_u, int y0_u, int width_u, int height_u);

  /// The lattice point (x, y). [u]
  const TruthSample& at(int x_u, int y_u);

  /// Any point.
  TruthSample at_point(double x_u, double y_u);

  const std::vector<BorderChain>& chains() const { return chains_; }
  const std::vector<Corner>& corners() const { return corners_; }
  const Shape& shape() const { return shape_; }

 private:
  // An edge a + t d, t = 0..1.
  struct NearEdge {
    double ax, ay, dx, dy;
    double inverse;  // 1 / |d|^2
    uint32_t number;
  };

  struct Block {
    bool ready = false;
    std::vector<NearEdge> edges;
  };

  void find_chains();
  const Block& block_of(int x_u, int y_u);
  TruthSample measure(const Block& block, double x, double y) const;

  const Shape& shape_;
  int x0_u_;
  int y0_u_;
  int width_u_;
  int blocks_x_;
  std::vector<Block> blocks_;
  std::vector<TruthSample> samples_;
  std::vector<bool> known_;
  std::vector<BorderChain> chains_;
  std::vector<Corner> corners_;
  std::vector<int16_t> chain_of_;       // of each edge
  std::vector<int16_t> corner_before_;  // at the start of each edge, or -1
  std::vector<uint32_t> next_;          // the edge after each edge
};

}  // namespace gen
}  // namespace inkcell
