// Where particles start, and where they belong.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/simulation/particles.hpp"
#include "inkcell/span.hpp"

namespace inkcell::simulation {

/// The place that a particle is pulled to. [1/16 px, y down]
struct ParticleHome {
  int16_t x_q4 = 0;
  int16_t y_q4 = 0;
};

/// Adds to each particle's speed `stiffness` (0 to 1) times its offset from
/// home, at most `most` px a step. With kept_q16 = 65536 (1 - 2
/// sqrt(stiffness)) particles arrive fast and do not swing. Particles without a
/// home are unchanged.
void pull_home(Span<Particle> particles,
               Span<const ParticleHome> homes,
               Q16_16 stiffness,
               Q26_6 most) noexcept;

/// Spreads homes evenly over the ink of a grid at (x, y), from left to right,
/// so that particles travel short distances between two texts with as many
/// homes. Up to 65536 homes; (x, y) within +-8191 px. False if the grid has no
/// ink: the homes are then untouched. The same seed gives the same homes.
bool spread_homes(const motion::DistanceGrid& grid,
                  int32_t x,
                  int32_t y,
                  uint32_t seed,
                  Span<ParticleHome> homes) noexcept;

/// Finds a place on an edge of the grid at (x, y): starts at a random place and
/// follows the gradient. False if 64 tries fail.
bool find_edge(const motion::DistanceGrid& grid,
               int32_t x,
               int32_t y,
               motion::RandomNumbers& random,
               Particle& out) noexcept;

}  // namespace inkcell::simulation
