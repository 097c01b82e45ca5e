// A grid that flowed, made a grid of distances again.
#pragma once

#include <stdint.h>

#include "inkcell/kinetic/distance_grid.hpp"

namespace inkcell {
namespace kinetic {

/// Fills `out`, as large as `grid` and apart from it, with distances to the
/// grid's edge: the slope becomes 1, and the edge stays where it is. Fast
/// sweeping (Zhao 2005): samples next to the edge follow from their value and
/// its slope, four sweeps fill the others. About 250 instructions a sample.
///
/// Grids that do not fit each other: `out` is untouched.
void redistance(const DistanceGrid& grid, DistanceGrid& out) noexcept;

}  // namespace kinetic
}  // namespace inkcell
