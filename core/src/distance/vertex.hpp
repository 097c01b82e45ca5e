// The distance to a convex vertex of two primitives.
#pragma once

#include <stdint.h>

#include "distance/primitive.hpp"

namespace inkcell {
namespace detail {

// The cosine of the angle between two gradients.
inline int32_t cosine_q14(const Vector& g_q14, const Vector& h_q14) noexcept {
  return wrapped(times(g_q14.x, static_cast<uint32_t>(h_q14.x)) +
                 times(g_q14.y, static_cast<uint32_t>(h_q14.y)) + (1 << 13)) >>
         14;
}

// Two values a and b of which the lesser is negative, as seen from the vertex
// where both are 0: with unit gradients g and h and c = g.h, the distance from
// it is |q|, g.q = a and h.q = b.
//
//   inside  |                  The vertex is the nearest point of the edge
//   . . . . V------  g         where q = (a - c b) g + (b - c a) h, but for a
//    h |   /  edge             positive factor, points away from both
//      | q/                    primitives.
//        p
struct Cone {
  int32_t a;  // scaled to 12 bits, both
  int32_t b;
  int32_t a_bc_q14;  // a - c b
  int32_t b_ac_q14;  // b - c a
  int32_t c_q14;
  int32_t scale_log2;
};

// Whether a point lies in the cone of the vertex. Nearly parallel primitives
// (1 - c^2 below 0.022) have none.
bool find_cone(int32_t a_q22,
               int32_t b_q22,
               int32_t c_q14,
               Cone& cone) noexcept;

// The lesser of two values, below 0, as it is rounded at the vertex of the two
// primitives between whose gradients this cosine is; the greater one is not
// farther from 0. [px]
int32_t rounded_q22(int32_t lesser_q22,
                    int32_t greater_q22,
                    int32_t c_q14) noexcept;

// The root rounded down.
uint32_t root(uint32_t value) noexcept;

}  // namespace detail
}  // namespace inkcell
