// Curves to chords, with a stated bound on the deviation.
#pragma once

#include <vector>

#include "shape/outline.hpp"

namespace inkcell {
namespace gen {

/// No point of a curve is farther than this from its chords, and no point of a
/// chord farther from the curve. [u] 1/4096 px at 64 px/em.
inline constexpr double kFlatteningBound = 1.0 / 256;

/// Chords that a curve needs: the smallest n with
///
///   max |B''| / (8 n^2) <= bound,
///
/// which is the error of linear interpolation at steps of 1/n. For a quadratic
/// B'' is 2 (p0 - 2 p1 + p2) all along; for a cubic it is a blend of
/// 6 (p0 - 2 p1 + p2) and 6 (p1 - 2 p2 + p3). At least 1.
int chord_count(const Segment& segment, double bound = kFlatteningBound);

/// The point of the segment at the parameter `t`, 0..1.
Point point_on(const Segment& segment, double t);

/// The corners of the polygon that stands for `contour`, without the closing
/// repetition of the first. Fewer than 3 if the contour encloses nothing.
///
/// Throws GeometryError::bad_coordinates.
std::vector<Point> flatten(const Contour& contour,
                           double bound = kFlatteningBound);

}  // namespace gen
}  // namespace inkcell
