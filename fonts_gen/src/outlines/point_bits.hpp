// The cost of a point in the font.
#pragma once

#include "outlines/outline_steps.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {

/// Mean length of a code word, before the code is known. [bits]
inline constexpr double kCodeWord_bits = 4.5;

/// Bits of a point at `to` that follows one at `from`, both on the grid.
inline double point_bits(const Point& from, const Point& to) {
  const Point d = to - from;
  return kCodeWord_bits + step_bits(static_cast<int>(d.x)) +
         step_bits(static_cast<int>(d.y));
}

}  // namespace inkcell::gen
