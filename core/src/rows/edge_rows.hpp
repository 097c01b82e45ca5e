// A line or parabola on its way through rows or columns of a band.
#pragma once

#include <stdint.h>

#include "rows/band.hpp"

namespace inkcell::detail {

inline void approach(uint8_t* pixel, int32_t nearness) noexcept {
  const int32_t old = *pixel;
  if (old < nearness) {
    *pixel = static_cast<uint8_t>(nearness | (old & 1));
  }
}

// The line from points[0] to points[2], or the curve with `is_bent`; not the
// pixels nearest to its ends. False, and nothing is done, if it must be halved
// before.
bool paint_edge(const Band& band,
                const PixelPoint* points,
                bool is_bent) noexcept;

}  // namespace inkcell::detail
