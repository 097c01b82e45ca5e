// Finds serifs, with and without a flat edge.
#pragma once

#include <vector>

#include "hints/strokes.hpp"

namespace inkcell::gen {

/// Whether `bar` is a thin bar at the end of a stem: nothing is beyond its
/// outer side, one narrower stroke on its inner side, and its wings are short.
bool is_serif(const Stroke& bar, const Border& border);

/// Turns the edges of cupped feet among `bars.lone` into serifs: strokes that
/// get wider towards a lower edge, without a flat upper edge.
void add_cupped_feet(const Border& border, Strokes& bars);

}  // namespace inkcell::gen
