// Turns a grid that flowed into a grid of distances again.
#pragma once

#include <stdint.h>

#include "inkcell/motion/distance_grid.hpp"

namespace inkcell::simulation {

/// Fills `out` with distances to the grid's edge: the slope becomes 1 and the
/// edge stays. Both grids have the same size and share no memory. Fast sweeping
/// (Zhao 2005): samples next to the edge follow from value and slope, four
/// sweeps fill the others. About 95 instructions a sample.
///
/// Computes the rows [first_row, end_row) and copies the others, so that the
/// work can be spread over frames, at least 10 rows at a time.
///
/// If the sizes differ, `out` is untouched.
void redistance(const motion::DistanceGrid& grid,
                motion::DistanceGrid& out,
                int32_t first_row = 0,
                int32_t end_row = motion::DistanceGrid::kMaxSide) noexcept;

}  // namespace inkcell::simulation
