// Outlines to distances and crossings, for pictures without greys.
#pragma once

#include <stdint.h>

#include "rows/band.hpp"

namespace inkcell::detail {

// Bytes of a band: the lowest bit toggles from outside to inside and back; the
// next two say whether the outline crosses the straight line from the centre of
// the pixel to the left, and of that above; the rest is nearness.
inline constexpr uint32_t kInsideBit = 1;
inline constexpr uint32_t kCrossedLeft = 2;
inline constexpr uint32_t kCrossedAbove = 4;
inline constexpr uint32_t kNearnessMask = 0xf8;

// Distances are good up to band.reach_q8.
void paint_crossings(const Band& band,
                     OutlineCursor& cursor,
                     const ScreenPoint* points,
                     const ScreenPoint* end) noexcept;

}  // namespace inkcell::detail
