// Rigid glyphs that fall, collide, slide and come to rest.
//
//   step(bodies, rules, contacts);  // a fixed time: 1/60 s or 1/120 s
//   for each strip:  for each body:  draw_body(...);  // body_draw.hpp
//
// The points of one body are looked up in the distances of the other
// (Guendelman et al. 2003). A step is divided into pieces in which two bodies
// move at most the distance between them (conservative advancement): no body
// passes through another, at any speed.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/simulation/body_shape.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::simulation {

/// The speed limit of all points of a body. [px a step]
inline constexpr int32_t kMostBodySpeed = 16;

/// How a neighbour or a wall deforms a soft body: the area that the contact
/// takes makes a bulge beside it; what the bulge cannot hold swells the body.
struct BodyTouch {
  uint8_t with = kNothing;  // the index of a body, or kWalls + the wall
  uint8_t bulge_q6 = 0;     // at the contact [px]
  uint8_t swell_q8 = 0;     // all around [px]

  static constexpr uint8_t kWalls = 64;  // left, top, right, bottom
  static constexpr uint8_t kNothing = 255;
};

/// A shape that moves. All values are safe: step() clamps them. Positions are
/// in px on the screen, y down, within +-8191.
struct Body {
  const BodyShape* shape = nullptr;  // must outlive it; null: not simulated
  Q16_16 x;                          // of the centre of mass
  Q16_16 y;
  Q16_16 x_speed;           // [px a step]
  Q16_16 y_speed;           // [px a step]
  uint32_t turn_q32 = 0;    // [turns, Q32], counter-clockwise on the screen
  int32_t spin_q20 = 0;     // [radians a step], counter-clockwise
  bool is_fixed = false;    // nothing moves it, as a wall
  uint8_t still_steps = 0;  // kStepsToSleep: asleep until hit
  /// Bodies and walls nearby at the last step, which draw_body() needs.
  static constexpr size_t kMostTouches = 6;
  BodyTouch touches[kMostTouches];
  /// draw_body() draws it flatter by this part of its height, 0 to 1/4, and so
  /// much wider that its area stays; its lowest line stays too. Written by
  /// step().
  Fixed<int16_t, 14> squash;
  // Written by step() only: the speed of the squash [Q14 a step], and the speed
  // at which it began [px a step]; the part of the step that the body has yet
  // to move [Q16], and the piece at hand; how far it may go at once [px], the
  // greatest speed of its points [px a step], and its speeds before the solver
  // ran.
  int16_t squash_speed_q14 = 0;
  int32_t fall_q16 = 0;
  int32_t left_q16 = 0;
  int32_t piece_q16 = 0;
  int32_t clear_q10 = 0;
  int32_t most_speed_q16 = 0;
  int32_t x_speed_before = 0;
  int32_t y_speed_before = 0;
  int32_t spin_before = 0;

  static constexpr uint8_t kStepsToSleep = 60;
  static constexpr int32_t kMostSquashQ14 = 1 << 12;

  motion::Angle angle() const noexcept {
    return motion::Angle::from_raw(static_cast<uint16_t>(turn_q32 >> 16));
  }
  bool is_asleep() const noexcept { return still_steps >= kStepsToSleep; }
};

/// Forces and limits of a step.
struct BodyRules {
  Rect walls;                  // bodies stay inside
  Q16_16 gravity;              // down [px a step, gained in a step]
  uint16_t bounce_q8 = 100;    // of the speed across a contact: 256 is elastic
  uint16_t friction_q8 = 100;  // of the force across a contact
  /// Soft bodies: how far edges may overlap, 0 to 8 px and at most a third of
  /// the body's depth. A spring pushes overlapping bodies apart; beyond this
  /// overlap they are rigid.
  Q6_10 overlap;
  uint16_t stiffness_q16 = 1000;  // [px a step, gained in a step, a px]
  uint16_t damping_q16 = 4000;    // of the speed across, lost in a step
  /// A body that falls on something is squashed, and springs back in 15 steps:
  /// the spring's speed, parts of the height a step, for each px a step that
  /// the fall loses. One blow squashes by 18 % of the height at most; slow
  /// bodies are not squashed. Only drawn: contacts are those of the body as it
  /// is. 0 to 8192.
  uint16_t squash_q14 = 0;
  /// The most pieces that a step of a body is divided into, 1 to kMostPieces.
  /// Bounds the cost of a step: bodies that need more pieces lose the rest of
  /// the step's time, with all that they touch. Others lose nothing. Collisions
  /// are never missed.
  uint8_t pieces = 60;
  /// Whether bodies are drawn after the step. If not, it leaves their touches
  /// alone, which costs less.
  bool is_drawn = true;

  static constexpr int32_t kMostPieces = 60;
};

/// A contact of two bodies, 64 bytes: scratch memory of step(), without meaning
/// between calls.
struct BodyContact {
  uint8_t first;
  uint8_t second;    // kWall: the first touches a wall
  int32_t gap_q10;   // to the rigid contact [px], below 0: overlap
  int32_t soft_q10;  // the part of the overlap that is soft [px]
  // The normal, towards the first. [Q14]
  int32_t nx;
  int32_t ny;
  // Arms of the normal and of the tangent (-ny, nx). [px, Q8]
  int32_t first_normal;
  int32_t second_normal;
  int32_t first_tangent;
  int32_t second_tangent;
  // Effective masses along the normal and the tangent. [px^2, Q8]
  int32_t normal_mass;
  int32_t tangent_mass;
  int32_t leaves_q16;  // the speed after the contact [px a step]
  int64_t pushed;      // [px a step px^2, Q16]
  int64_t rubbed;

  static constexpr uint8_t kWall = 255;
};

/// The most contacts of two bodies, or of a body and a wall.
inline constexpr size_t kContactsOfPair = 4;

/// Only the first kMostBodies bodies are simulated.
inline constexpr size_t kMostBodies = 64;

/// Moves bodies by one step. Pairs for which `contacts` has not kContactsOfPair
/// free entries are ignored; a heap of n letters has at most 3 n touching
/// pairs.
void step(Span<Body> bodies,
          const BodyRules& rules,
          Span<BodyContact> contacts) noexcept;

/// Whether all bodies that are not fixed sleep.
bool are_asleep(Span<const Body> bodies) noexcept;

/// The pixels that a body may touch. [px on the screen]
Rect box_of(const Body& body) noexcept;

}  // namespace inkcell::simulation
