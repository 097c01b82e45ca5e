// Contours that overlap become contours that do not.
#pragma once

#include "shape/outline.hpp"

namespace inkcell {
namespace gen {

/// The border of what `outline` fills under the non-zero rule: closed contours
/// that neither cross nor overlap, though they may touch in points, filled on
/// the left. Curves stay curves. Contours that fill nothing are dropped.
///
/// The result is compared with Shape, the union of the flattened contours. If
/// they differ, as they may where curves run along each other, the contours of
/// Shape are returned: chords within kFlatteningBound.
///
/// Throws GeometryError.
Outline unite(const Outline& outline);

}  // namespace gen
}  // namespace inkcell
