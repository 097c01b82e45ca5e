// Removes overlaps of contours.
#pragma once

#include "shape/outline.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {

/// The border of the area that `outline` fills under the non-zero rule: closed
/// contours, filled on the left, that neither cross nor overlap; they may touch
/// in points. Contours that fill nothing are dropped.
///
/// Has the contours of Shape, but with segments of the source, or parts of
/// them, in place of chords: curves stay curves, and corners do not move. No
/// point is farther from the border of Shape than 2 kFlatteningBound.
///
/// Throws GeometryError.
Outline unite(const Outline& outline);

/// The same, for callers that have the Shape of `outline`.
Outline unite(const Outline& outline, const Shape& shape);

}  // namespace inkcell::gen
