// What a pen of constant width covers.
#pragma once

#include <vector>

#include "svg/path_data.hpp"
#include "svg/region.hpp"
#include "svg/style.hpp"

namespace inkcell::gen {

/// Polygons whose union is the stroke of `subpath` (SVG 1.1, section 11.4), in
/// its units: a rectangle for each chord, and what joins and caps add. Curves
/// and round joins are chords within `bound`. So no cusp, no loop and no curve
/// tighter than the pen is a special case.
std::vector<Corners> stroke_pieces(const Subpath& subpath,
                                   const PenStyle& pen,
                                   double bound);

}  // namespace inkcell::gen
