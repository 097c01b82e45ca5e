// Reflections and quarter turns of a sampled field, without loss.
#pragma once

#include "samples/sample_tree.hpp"

namespace inkcell {
namespace gen {

/// One of the eight maps of a square onto itself: x' = xx x + xy y,
/// y' = yx x + yy y, with one entry of each row and column +-1, the other 0.
struct Symmetry {
  int xx = 1;
  int xy = 0;
  int yx = 0;
  int yy = 1;
};

/// The field of the shape that `symmetry` and then a step of (dx_u, dy_u) make
/// of the shape of `tree`: the same cells at other places, each with the same
/// nine distances in another order. Exact; four quarter turns about a point
/// give the same tree again.
///
/// Throws GeometryError::too_large if the grid leaves the format's range.
SampleTree permuted(const SampleTree& tree,
                    const Symmetry& symmetry,
                    int dx_u,
                    int dy_u);

}  // namespace gen
}  // namespace inkcell
