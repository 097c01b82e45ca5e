// Where particles come from, and where they belong.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/kinetic/distance_grid.hpp"
#include "inkcell/kinetic/numbers.hpp"
#include "inkcell/kinetic/particles.hpp"
#include "inkcell/span.hpp"

namespace inkcell {
namespace kinetic {

/// Where a particle belongs. [1/16 px, y down]
struct ParticleHome {
  int16_t x_q4 = 0;
  int16_t y_q4 = 0;
};

/// Adds to the speed of each particle `stiffness` of its way home, 0 to 1, up
/// to `most` px a step. With kept_q16 = 65536 (1 - 2 sqrt(stiffness)) they
/// arrive fast and do not swing. Particles without a home are left alone.
void pull_home(Span<Particle> particles,
               Span<const ParticleHome> homes,
               Q16_16 stiffness,
               Q26_6 most) noexcept;

/// Homes spread evenly over the inside of a grid at (x, y), from left to right,
/// so that two texts with as many homes pass particles over short ways. Up to
/// 65536 homes; (x, y) within +-8191 px. False if nothing is inside: the homes
/// are then untouched. The same for the same seed.
bool spread_homes(const DistanceGrid& grid,
                  int32_t x,
                  int32_t y,
                  uint32_t seed,
                  Span<ParticleHome> homes) noexcept;

/// A place on an edge of the grid at (x, y): from a random one within reach
/// along the gradient. False if 64 places were in vain.
bool find_edge(const DistanceGrid& grid,
               int32_t x,
               int32_t y,
               RandomNumbers& random,
               Particle& out) noexcept;

}  // namespace kinetic
}  // namespace inkcell
