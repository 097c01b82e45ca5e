// A grid that flowed, made a grid of distances again.
#pragma once

#include <stdint.h>

#include "inkcell/kinetic/distance_grid.hpp"

namespace inkcell {
namespace kinetic {

/// Fills `out`, as large as `grid` and apart from it, with distances to the
/// grid's edge: the slope becomes 1, and the edge stays where it is. Fast
/// sweeping (Zhao 2005): samples next to the edge follow from their value and
/// its slope, four sweeps fill the others. About 120 instructions a sample.
///
/// Of rows from `first_row` up to `end_row`; others are copied. So the work can
/// be spread over frames: 10 rows and more at a time.
///
/// Grids that do not fit each other: `out` is untouched.
void redistance(const DistanceGrid& grid,
                DistanceGrid& out,
                int32_t first_row = 0,
                int32_t end_row = DistanceGrid::kMaxSide) noexcept;

}  // namespace kinetic
}  // namespace inkcell
