// Converts curves to chords, with a bound on the error.
#pragma once

#include <vector>

#include "shape/outline.hpp"

namespace inkcell::gen {

/// The largest distance between a curve and its chords, in both directions. [u]
/// 1/4096 px at 64 px/em.
inline constexpr double kFlatteningBound = 1.0 / 256;

/// The number of chords that a curve needs: the smallest n >= 1 with
///
///   max |B''| / (8 n^2) <= bound,
///
/// the error of linear interpolation at steps of 1/n. B'' of a quadratic is 2
/// (p0 - 2 p1 + p2) everywhere; of a cubic it is a blend of 6 (p0 - 2 p1 + p2)
/// and 6 (p1 - 2 p2 + p3).
int chord_count(const Segment& segment, double bound = kFlatteningBound);

/// The point of the segment at the parameter `t`, 0..1.
Point point_on(const Segment& segment, double t);

/// The corners of the polygon of `contour`; the first is not repeated. Fewer
/// than 3 if the contour encloses nothing.
///
/// Throws GeometryError::bad_coordinates.
std::vector<Point> flatten(const Contour& contour,
                           double bound = kFlatteningBound);

}  // namespace inkcell::gen
