// Melts a shape into a puddle, and freezes another one out of it (level sets).
//
//   Melting how;
//   how.floor = 40_px;
//   how.area = grid.area();
//   melt(grid, how, scratch);   // a step
//   redistance(grid, next);
//   ...
//   freeze(next, word, 12);     // a step
//   redistance(next, grid);
//
// Both need grids of distances: redistance() after each step.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/motion/grid_blend.hpp"

namespace inkcell::simulation {

/// How a shape melts.
struct Melting {
  Q26_6 floor;           // [px from the grid's upper edge] Nothing is below it.
  Q26_6 beside;          // [px] Nothing is nearer to the grid's sides.
  int32_t speed_q8 = 0;  // the fastest column [samples a step], at most 4
  Q26_6 drip = Q26_6::from_int(4);  // [px] The width of columns of one speed.
  /// DistanceGrid::area() of the shape: what sinks spreads as a puddle until
  /// the area is this again. [1/64 of a sample]
  int32_t area = 0;
  uint32_t seed = 0;  // of the speeds of columns
};

/// A step: each column of samples sinks at its own speed, slower within 5/8 of
/// a drip's width of the floor. About 60 instructions a sample of the box of
/// known ones.
void melt(motion::DistanceGrid& grid,
          const Melting& how,
          motion::GridHistogram& scratch) noexcept;

/// A step: edges inside of the target grow, others shrink, by at most `most` (1
/// to 255), slower where they are near its edge: they leave no steps there. The
/// target is filled from where the grid overlaps it; steps without
/// redistance() also fill the other parts, and end with the target itself.
/// [1/32 of a sample] If the sizes differ, `grid` is untouched.
void freeze(motion::DistanceGrid& grid,
            const motion::DistanceGrid& target,
            int32_t most) noexcept;

}  // namespace inkcell::simulation
