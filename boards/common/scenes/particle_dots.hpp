// Particles as dots on a strip.
#pragma once

#include "inkcell/simulation/dots.hpp"
#include "inkcell/simulation/particles.hpp"
#include "paper.hpp"

namespace inkcell::scenes {

constexpr int32_t magnitude(int32_t value) noexcept {
  return value < 0 ? -value : value;
}

/// 0 at rest to 256.
constexpr int32_t heat_of(const simulation::Particle& p) noexcept {
  const int32_t heat =
      (magnitude(p.x_speed_q10) + magnitude(p.y_speed_q10)) >> 4;
  return heat < 256 ? heat : 256;
}

/// The part of a dot's radius that is shown: dots vanish where a loop begins,
/// and are placed anew. [of 256]
constexpr int32_t shown_at(uint32_t frame) noexcept {
  constexpr uint32_t kFrames = 12;
  const uint32_t since = frame % kLoopFrames;
  const uint32_t near =
      since < kLoopFrames - since ? since : kLoopFrames - since;
  return static_cast<int32_t>(near < kFrames ? near * 256 / kFrames : 256);
}

/// Whether a dot of up to 2 px may touch rows of a window.
constexpr bool is_near(const simulation::Particle& p,
                       const Rect& window) noexcept {
  constexpr int32_t kReach = 3;  // [px]
  const int32_t y = p.y.raw >> 16;
  return y >= window.y0 - kReach && y < window.y1 + kReach;
}

/// The box with dots of up to 2 px.
inline Rect with_dots(Rect box,
                      Span<const simulation::Particle> particles) noexcept {
  for (const simulation::Particle& p : particles) {
    box = bounding_box(box, simulation::dot_box(p.x, p.y, Q26_6::from_int(2)));
  }
  return box;
}

inline void tell_particles(Span<const simulation::Particle> particles,
                           const StateSink& sink) noexcept {
  for (const simulation::Particle& p : particles) {
    sink.tell(p.x.raw);
    sink.tell(p.y.raw);
    sink.tell(p.x_speed_q10);
    sink.tell(p.y_speed_q10);
  }
}

}  // namespace inkcell::scenes
