// A grid of distances that flows: level sets.
//
//   advect(grid, flow, next);      // the shape moves with the flow
//   redistance(next, grid);        // every 8th step or so
//
// Osher and Sethian 1988; semi-Lagrangian: each sample looks back to where it
// was a step ago, and takes what is there, by a cubic in each direction. Shapes
// part and join by themselves.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/kinetic/distance_grid.hpp"
#include "inkcell/span.hpp"

namespace inkcell {
namespace kinetic {

/// A vortex: at the distance r from its centre things turn by
/// strength / (r^2 + core^2), r and core in samples. Its flow is free of
/// divergence: areas stay.
struct Vortex {
  Q16_16 x;  // of the centre, in samples from the grid's upper left corner
  Q16_16 y;
  int32_t strength = 0;  // [samples^2 / 256 a step]; above 0 counter-clockwise
  int32_t core = 1;      // [samples] 1 to 255
};

/// What moves a grid in a step.
struct Flow {
  Span<const Vortex> vortices;  // at most kMaxVortices are used
  Q16_16 x_drift;               // [samples a step]
  Q16_16 y_drift;

  static constexpr size_t kMaxVortices = 4;
};

/// Fills `out`, as large as `grid` and apart from it, with the grid moved by a
/// step of a flow. A sample moves at most 16 samples, farther flows are cut. Of
/// samples far from edges it costs about 80 instructions and a division for
/// each vortex, near them about 150 more.
///
/// Grids that do not fit each other: `out` is untouched.
void advect(const DistanceGrid& grid,
            const Flow& flow,
            DistanceGrid& out) noexcept;

}  // namespace kinetic
}  // namespace inkcell
