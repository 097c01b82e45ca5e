// Chooses the first point of each contour, and the order of contours.
#pragma once

#include "outlines/minimal_outline.hpp"

namespace inkcell::gen {

/// Rotates and reorders contours so that steps from one to the next are short
/// and closing edges, which are not stored, are long. On entry and on return
/// the first point of a contour is on the curve and, if possible, a corner. (x,
/// y) is the start of the pen. [grid units]
void order_contours(int x, int y, MinimalOutline& outline);

}  // namespace inkcell::gen
