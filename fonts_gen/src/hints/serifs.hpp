// Which bars are serifs, and serifs without a flat edge.
#pragma once

#include <vector>

#include "hints/strokes.hpp"

namespace inkcell::gen {

/// Whether `bar` is a thin bar at the end of a stem: nothing lies beyond its
/// outer side, one narrower stroke on its inner side, and its wings are short.
bool is_serif(const Stroke& bar, const Border& border);

/// The cupped feet that end in the lower edges of `bars.lone`: near their ends
/// strokes are wider, without a flat upper edge. The edges become serifs.
void add_cupped_feet(const Border& border, Strokes& bars);

}  // namespace inkcell::gen
