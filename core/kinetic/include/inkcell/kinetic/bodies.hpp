// Rigid glyphs that fall, collide, slide and come to rest.
//
//   step(bodies, rules, contacts);  // a fixed time: 1/60 s or 1/120 s
//   for each strip:  for each body:  draw_body(...);  // body_draw.hpp
//
// The points of one body are looked up in the distances of the other
// (Guendelman et al. 2003). A step is divided: two bodies move at most the way
// between them (conservative advancement), so nothing is passed at any speed.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/kinetic/body_shape.hpp"
#include "inkcell/kinetic/numbers.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace kinetic {

/// No point of a body moves faster. [px a step]
inline constexpr int32_t kMostBodySpeed = 16;

/// A shape that moves. Any numbers are safe: step() clamps them. The place is
/// in px on the screen, y down, within +-8191.
struct Body {
  const BodyShape* shape = nullptr;  // must outlive it; none: nothing happens
  Q16_16 x;                          // of the centre of mass
  Q16_16 y;
  Q16_16 x_speed;           // [px a step]
  Q16_16 y_speed;           // [px a step]
  uint32_t turn_q32 = 0;    // of a turn, counter-clockwise as one sees it
  int32_t spin_q20 = 0;     // [radians a step], counter-clockwise
  bool is_fixed = false;    // like a wall: nothing moves it
  uint8_t still_steps = 0;  // kStepsToSleep: it sleeps until it is hit
  /// The deepest overlap with another body or a wall at the last step. [px]
  Q6_10 squeeze;
  // Of use to step() alone: how far it may go at once [px], how fast its points
  // are at most [px a step], and its speeds before contacts were solved.
  int32_t clear_q10 = 0;
  int32_t most_speed_q16 = 0;
  int32_t x_speed_before = 0;
  int32_t y_speed_before = 0;
  int32_t spin_before = 0;

  static constexpr uint8_t kStepsToSleep = 60;

  Angle angle() const noexcept {
    return Angle::from_raw(static_cast<uint16_t>(turn_q32 >> 16));
  }
  bool is_asleep() const noexcept { return still_steps >= kStepsToSleep; }
};

/// What works on bodies in a step.
struct BodyRules {
  Rect walls;                  // nothing leaves it
  Q16_16 gravity;              // down [px a step, gained in a step]
  uint16_t bounce_q8 = 100;    // of the speed across a contact: 256 is elastic
  uint16_t friction_q8 = 100;  // of the force across a contact
  /// Soft bodies: how far edges may pass each other, 0 to 8 px, and no farther
  /// than half of their depth; beyond that they are rigid. Up to there a spring
  /// pushes them apart.
  Q6_10 overlap;
  uint16_t stiffness_q16 = 1000;  // [px a step, gained in a step, a px]
  uint16_t damping_q16 = 4000;    // of the speed across, lost in a step
  /// Pieces of a step at most, 1 to kMostPieces: the bound of what it costs.
  /// What is left of the time then is lost, never a collision.
  uint8_t pieces = 60;

  static constexpr int32_t kMostPieces = 60;
};

/// Where two bodies touch: what step() works with, 64 bytes. The content has no
/// meaning between calls.
struct BodyContact {
  uint8_t first;
  uint8_t second;    // kWall: the first touches a wall
  int32_t gap_q10;   // to where both are rigid [px], below 0 if they overlap
  int32_t soft_q10;  // the part of the overlap that is soft [px]
  // The normal, towards the first. [Q14]
  int32_t nx;
  int32_t ny;
  // Arms of the normal and of the tangent (-ny, nx). [px, Q8]
  int32_t first_normal;
  int32_t second_normal;
  int32_t first_tangent;
  int32_t second_tangent;
  // What a change of speed takes. [px^2, Q8]
  int32_t normal_mass;
  int32_t tangent_mass;
  int32_t leaves_q16;  // with this speed [px a step]
  int64_t pushed;      // [px a step px^2, Q16]
  int64_t rubbed;

  static constexpr uint8_t kWall = 255;
};

/// How many contacts a pair of bodies, or a body and a wall, have at most.
inline constexpr size_t kContactsOfPair = 4;

/// At most so many bodies take part.
inline constexpr size_t kMostBodies = 64;

/// Moves bodies by a step: gravity, contacts, speeds, places, in this order.
/// Contacts that do not fit are left out: of n letters in a heap 3 n pairs
/// touch at most.
void step(Span<Body> bodies,
          const BodyRules& rules,
          Span<BodyContact> contacts) noexcept;

/// Whether all that are not fixed sleep.
bool are_asleep(Span<const Body> bodies) noexcept;

/// Where a body may have ink. [px on the screen]
Rect box_of(const Body& body) noexcept;

}  // namespace kinetic
}  // namespace inkcell
