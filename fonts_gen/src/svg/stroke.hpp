// The area that a pen of constant width covers.
#pragma once

#include <vector>

#include "svg/path_data.hpp"
#include "svg/region.hpp"
#include "svg/style.hpp"

namespace inkcell::gen {

/// Polygons whose union is the stroke of `subpath` (SVG 1.1, section 11.4), in
/// its units: a rectangle for each chord, joins and caps. Curves and round
/// joins are chords within `bound`, so cusps, loops and curves tighter than the
/// pen need no special case.
std::vector<Corners> stroke_pieces(const Subpath& subpath,
                                   const PenStyle& pen,
                                   double bound);

}  // namespace inkcell::gen
