// Particles that feel the distances of glyphs: attraction, orbits, bounces.
//
//   pull_home(particles, homes, stiffness, most);
//   step(particles, rules, grid, 0, 0);
//   for each strip:  for each particle:  draw_dot(p.x, p.y, radius, sink);
//
// Positions and speeds are integers, and a step is a fixed time: the same on
// every core, whatever the frame rate.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/kinetic/distance_grid.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace kinetic {

/// 12 bytes. The place is in px on the screen, y down.
struct Particle {
  Q16_16 x;
  Q16_16 y;
  int16_t x_speed_q10 = 0;  // [px a step] within +-kMostSpeedQ10
  int16_t y_speed_q10 = 0;
};

/// 16 px a step.
inline constexpr int32_t kMostSpeedQ10 = 16 << 10;

/// On which side of the glyphs' edges particles stay.
enum class ParticleSide : uint8_t { both, outside, inside };

/// What works on particles in a step.
struct ParticleRules {
  Rect walls;                 // the centres of particles stay in it
  int16_t gravity_q10 = 0;    // down [px a step, gained in a step]
  uint16_t kept_q16 = 65535;  // of the speed, after each step
  uint16_t bounce_q8 = 128;   // of the speed across an edge: 256 is elastic
  ParticleSide side = ParticleSide::both;
  /// Towards the inside of glyphs, and round them, where the grid knows a
  /// slope: within 4 samples of an edge. Below 0: the other way.
  /// [px a step, gained in a step]
  int16_t attraction_q10 = 0;
  int16_t orbit_q10 = 0;
  /// How far outside of an edge particles bounce: their radius.
  Q26_6 radius;
};

/// Moves particles by a step: forces, speed, place, edges, walls. A particle
/// moves at most as far as it is away from an edge, or 1 px, and looks again:
/// so none passes a stroke of 2 px or more. (x, y) is the grid's upper left
/// corner on the screen.
void step(Span<Particle> particles,
          const ParticleRules& rules,
          const DistanceGrid& grid,
          int32_t x,
          int32_t y) noexcept;

/// Whether none moves.
bool are_at_rest(Span<const Particle> particles) noexcept;

}  // namespace kinetic
}  // namespace inkcell
