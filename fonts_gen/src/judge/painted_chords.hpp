// The chords that the device draws in place of curves, with the filter area.
#pragma once

#include "judge/moved_area.hpp"
#include "outlines/minimal_outline.hpp"

namespace inkcell::gen {

/// How many chords a curve gets where the roundings of its points decide.
enum class ChordNumber : uint8_t { fewer, more };

/// What paint_areas() adds to `outline` at a size, roundings apart: for each
/// curve the area between it and its chords, counter-clockwise if the chords
/// lie outside. [u]
Polygons chord_strays(const MinimalOutline& outline,
                      double u_per_grid,
                      int px,
                      ChordNumber number);

}  // namespace inkcell::gen
