// Outlines to exact coverage: how much of each pixel lies inside.
#pragma once

#include "rows/band.hpp"

namespace inkcell::detail {

// Paints points into a band; pixels begin at whole numbers. Bytes are explained
// in area_painter.cpp; a row becomes coverage by cover_areas().
void paint_areas(const Band& band,
                 OutlineCursor& cursor,
                 const ScreenPoint* points,
                 const ScreenPoint* end) noexcept;

}  // namespace inkcell::detail
