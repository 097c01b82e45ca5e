// Outlines to rows of distances, within half a pixel of the edge.
#pragma once

#include "rows/band.hpp"

namespace inkcell::detail {

// Paints points into a band; centres of pixels lie at whole numbers. Bytes are
// explained in distance_painter.cpp; a row becomes coverage by cover_linear().
void paint_distances(const Band& band,
                     OutlineCursor& cursor,
                     const ScreenPoint* points,
                     const ScreenPoint* end) noexcept;

}  // namespace inkcell::detail
