// Converts points on the grid back to segments.
#pragma once

#include "outlines/minimal_outline.hpp"
#include "shape/outline.hpp"

namespace inkcell::gen {

/// The segments of a contour, of at least one point.
Contour expand(const MinimalContour& minimal, double u_per_grid);

/// The segments of `outline`, in u.
Outline expand(const MinimalOutline& outline, int units_per_em, int grid_shift);

}  // namespace inkcell::gen
