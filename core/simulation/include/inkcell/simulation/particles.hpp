// Particles that react to the distances of glyphs: attraction, orbits, bounces.
//
//   pull_home(particles, homes, stiffness, most);
//   step(particles, rules, grid, 0, 0);
//   for each strip:  for each particle:  draw_dot(p.x, p.y, radius, sink);
//
// Positions and speeds are integers, and a step is a fixed time: the result is
// the same on every core, at any frame rate.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::simulation {

/// 12 bytes. Position in px on the screen, y down.
struct Particle {
  Q16_16 x;
  Q16_16 y;
  int16_t x_speed_q10 = 0;  // [px a step] within +-kMostSpeedQ10
  int16_t y_speed_q10 = 0;
};

/// 16 px a step.
inline constexpr int32_t kMostSpeedQ10 = 16 << 10;

/// The side of the glyphs' edges on which particles stay.
enum class ParticleSide : uint8_t { both, outside, inside };

/// Forces and limits of a step.
struct ParticleRules {
  Rect walls;                 // centres of particles stay inside
  int16_t gravity_q10 = 0;    // down [px a step, gained in a step]
  uint16_t kept_q16 = 65535;  // of the speed, after each step
  uint16_t bounce_q8 = 128;   // of the speed across an edge: 256 is elastic
  ParticleSide side = ParticleSide::both;
  /// Acceleration towards the inside of glyphs, and around them; the opposite
  /// if below 0. Acts within 4 samples of an edge, where the grid has a slope.
  /// [px a step, gained in a step]
  int16_t attraction_q10 = 0;
  int16_t orbit_q10 = 0;
  /// Particles bounce at this distance from an edge: their radius.
  Q26_6 radius;
};

/// Moves particles by one step. A particle moves at most its distance from the
/// edge, or 1 px, before the distance is looked up again: it never passes
/// through a stroke of 2 px or more. (x, y) is the grid's upper left corner on
/// the screen.
void step(Span<Particle> particles,
          const ParticleRules& rules,
          const motion::DistanceGrid& grid,
          int32_t x,
          int32_t y) noexcept;

/// Whether no particle moves.
bool are_at_rest(Span<const Particle> particles) noexcept;

}  // namespace inkcell::simulation
