// Outlines to rows of distances, up to 4 px from the edge.
#pragma once

#include "rows/band.hpp"

namespace inkcell::detail {

// As paint_distances, with band.reach_q8 instead of half a pixel: for filters
// with wide ramps, weights, strokes and glows.
void paint_wide_distances(const Band& band,
                          OutlineCursor& cursor,
                          const ScreenPoint* points,
                          const ScreenPoint* end) noexcept;

}  // namespace inkcell::detail
