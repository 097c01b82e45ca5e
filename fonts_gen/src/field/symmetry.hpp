// Reflections and quarter turns of a sampled field, without loss.
#pragma once

#include "field/sample_tree.hpp"

namespace inkcell::gen {

/// One of the eight maps of a square onto itself: x' = xx x + xy y,
/// y' = yx x + yy y, with one entry of each row and column +-1, the other 0.
struct Symmetry {
  int xx = 1;
  int xy = 0;
  int yx = 0;
  int yy = 1;
};

/// The field of `tree`, mapped by `symmetry` and then moved by (dx_u, dy_u).
/// [u] Its cells are at other places, and the nine distances of each are in
/// another order. Nothing is rounded: four quarter turns about a point give the
/// same tree again.
///
/// Throws GeometryError::too_large if the grid leaves the format's range.
SampleTree permuted(const SampleTree& tree,
                    const Symmetry& symmetry,
                    int dx_u,
                    int dy_u);

}  // namespace inkcell::gen
