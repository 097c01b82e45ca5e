// Contours that overlap become contours that do not.
#pragma once

#include "shape/outline.hpp"
#include "shape/shape.hpp"

namespace inkcell {
namespace gen {

/// The border of what `outline` fills under the non-zero rule: closed contours
/// that neither cross nor overlap, though they may touch in points, filled on
/// the left. Contours that fill nothing are dropped.
///
/// They are those of Shape, with the source's own segments, or parts of them,
/// in place of their chords: curves stay curves, and corners stay where they
/// are. No point is farther from the border of Shape than 2 kFlatteningBound.
///
/// Throws GeometryError.
Outline unite(const Outline& outline);

/// The same where `shape`, that of `outline`, is known.
Outline unite(const Outline& outline, const Shape& shape);

}  // namespace gen
}  // namespace inkcell
