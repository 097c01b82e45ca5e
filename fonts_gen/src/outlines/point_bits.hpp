// The cost of a point in the font.
#pragma once

#include "shape/points.hpp"

namespace inkcell::gen {

/// Mean length of a code word, before the code is known. [bits]
inline constexpr double kCodeWord_bits = 4.5;

/// Bits of `value` in two's complement; none for 0.
inline int width_of(int value) {
  int width = 0;
  if (value != 0) {
    const unsigned rest = static_cast<unsigned>(value < 0 ? ~value : value);
    for (width = 1; rest >> (width - 1) != 0; ++width) {
    }
  }
  return width;
}

/// Bits of a point at `to` that follows one at `from`, both on the grid.
inline double point_bits(const Point& from, const Point& to) {
  const Point d = to - from;
  return kCodeWord_bits + width_of(static_cast<int>(d.x)) +
         width_of(static_cast<int>(d.y));
}

}  // namespace inkcell::gen
