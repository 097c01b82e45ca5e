// Where contours start, and which comes first.
#pragma once

#include "outlines/minimal_outline.hpp"

namespace inkcell {
namespace gen {

/// Turns contours and puts them in an order so that moves from one to the next
/// are short and closing edges, which are left out, are long. On entry and on
/// return a contour's first point is on the curve and, if any is, a corner.
/// (x, y) is where the pen starts. [grid units]
void order_contours(int x, int y, MinimalOutline& outline);

}  // namespace gen
}  // namespace inkcell
