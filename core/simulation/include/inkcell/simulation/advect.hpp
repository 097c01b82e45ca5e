// Moves a grid of distances with a flow (level sets).
//
//   advect(grid, flow, next);      // the shape moves with the flow
//   redistance(next, grid);        // every 8th step or so
//
// Semi-Lagrangian (Osher and Sethian 1988): each sample looks up, by a bicubic,
// the value at the place where it was a step ago. Shapes split and merge by
// themselves.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/span.hpp"

namespace inkcell::simulation {

/// A vortex: points at the distance r from its centre turn by strength / (r^2 +
/// core^2) a step, r and core in samples. The flow is free of divergence: areas
/// are kept.
struct Vortex {
  Q16_16 x;  // of the centre, in samples from the grid's upper left corner
  Q16_16 y;
  int32_t strength = 0;  // [samples^2 / 256 a step]; above 0 counter-clockwise
  int32_t core = 1;      // [samples] 1 to 255
};

/// The flow of one step.
struct Flow {
  Span<const Vortex> vortices;  // at most kMaxVortices are used
  Q16_16 x_drift;               // [samples a step]
  Q16_16 y_drift;

  static constexpr size_t kMaxVortices = 4;
};

/// Fills `out` with `grid`, moved by one step of a flow. Both grids have the
/// same size and share no memory. A sample moves at most 16 samples; faster
/// flows are clamped. Cost: about 80 instructions a sample and a division for
/// each vortex; near edges about 150 more.
///
/// If the sizes differ, `out` is untouched.
void advect(const motion::DistanceGrid& grid,
            const Flow& flow,
            motion::DistanceGrid& out) noexcept;

/// Fills `out` with `grid`, wound up by a vortex for any time: `strength` is
/// that of all steps, within +-2^26; no point turns by more than 5 turns.
/// Points move on circles, so each sample is looked up once, where it was: the
/// reverse gives back the shape, and nothing wears off. The slope grows:
/// redistance() restores it. `grid` may be smaller than `out`, in which it lies
/// at (`left`, `top`), clamped to +-4096; the vortex is in samples of `out`.
/// They share no memory. Cost: about 110 instructions for a sample of the
/// circle that holds the shape.
void wind(const motion::DistanceGrid& grid,
          int32_t left,
          int32_t top,
          const Vortex& vortex,
          motion::DistanceGrid& out) noexcept;

}  // namespace inkcell::simulation
