// Finds the chains of a contour.
#pragma once

#include <cstddef>
#include <vector>

#include "outlines/chain_search.hpp"

namespace inkcell::gen {

/// A chain and the nodes at its ends.
struct PathStep {
  size_t first = 0;
  size_t last = 0;
  Chain chain;
};

/// The chains around a contour that take the fewest bits, from node 0 back to
/// node 0, by dynamic programming over the nodes.
std::vector<PathStep> cheapest_path(const Trace& trace,
                                    const ChainSearch& search);

/// Joins neighbours whose joint can be midway between their control points, and
/// moves points slightly where that takes fewer bits.
void drop_joints(const ChainSearch& search, std::vector<PathStep>& path);

}  // namespace inkcell::gen
