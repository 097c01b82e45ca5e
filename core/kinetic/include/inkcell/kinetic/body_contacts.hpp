// Where bodies touch, and how far they are apart: what step() of bodies uses.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/kinetic/bodies.hpp"
#include "inkcell/span.hpp"

namespace inkcell {
namespace kinetic {

/// Bodies that are nearer than this touch. [px, Q10]
inline constexpr int32_t kTouchQ10 = 256;

/// Bodies that touch slide this far before they are looked at again; soft ones
/// farther. [px, Q10]
inline int32_t slide_q10(const BodyRules& rules) noexcept {
  return 512 + rules.overlap.raw / 4;
}

/// Rigid bodies keep this far apart: grids round corners off by as much.
/// [px, Q10]
inline constexpr int32_t kSkinQ10 = 160;

/// What is farther than any way of a piece. [px, Q10]
inline constexpr int32_t kFarQ10 = 64 << 10;

/// Products of 32 bits, to the nearest.
inline int32_t scaled(int64_t value, uint32_t shift) noexcept {
  return static_cast<int32_t>((value + (int64_t{1} << (shift - 1))) >> shift);
}

/// A rotation counter-clockwise as one sees it. [Q14]
struct Turn {
  int32_t cosine;
  int32_t sine;
};

inline Turn turn_of(Angle angle) noexcept {
  return {cosine(angle).raw, sine(angle).raw};
}

/// No point of a body moves faster. [px a step, Q16]
int32_t speed_of(const Body& body) noexcept;

/// No two points of both move faster against each other. [px a step, Q16]
int32_t speed_between(const Body& a, const Body& b) noexcept;

/// Finds contacts and wakes who is hit. Sets squeeze, most_speed_q16 and
/// clear_q10 of each body: how far it may go before it meets what it does not
/// touch, and walls. Sets all of a contact but what solving needs. Returns
/// their number.
size_t find_contacts(Span<Body> bodies,
                     const BodyRules& rules,
                     int32_t still_q16,
                     Span<BodyContact> contacts) noexcept;

}  // namespace kinetic
}  // namespace inkcell
