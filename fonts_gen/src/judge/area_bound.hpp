// What the filter area promises of a glyph at any position.
#pragma once

#include "judge/closed_loop.hpp"
#include "outlines/minimal_outline.hpp"
#include "outlines/refit.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {

/// What roundings of points, slopes and areas add to a pixel, apart from rare
/// pixels in small sizes, where what was moved counts little. [1/255]
inline constexpr double kAreaRounding = 4;

/// Bounds how far pixels of `outline`, drawn with the filter area at any
/// position and size of the options, are from the area of `source`: by the area
/// that the refit moved, the chords that the device draws for curves, and
/// kAreaRounding. `misses` are pixels whose bound is beyond the tolerance.
/// Leaves out the errors of each size.
///
/// Throws GeometryError.
LoopResult bound_areas(const Shape& source,
                       const MinimalOutline& outline,
                       const RefitOptions& refit,
                       const LoopOptions& options);

}  // namespace inkcell::gen
