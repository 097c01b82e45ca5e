// Smooth curves through few points, the knots of a path.
#pragma once

#include <vector>

#include "stroke/stroke.hpp"

namespace inkcell::design {

/// A curve through all points, one piece for each pair of neighbours. The
/// tangent at a knot is that of the circle through it and its neighbours, so
/// that a knot that moves bends four pieces at most; handles are as long as
/// Hobby (1986) has them. A path that ends where it begins is closed smoothly.
/// Neighbours must differ.
std::vector<gen::Segment> smooth_path(const std::vector<StrokePoint>& points);

/// The few of the `drawn` points, with corners where they turn sharply, whose
/// smooth path passes all of them within `tolerance`.
std::vector<StrokePoint> knots_of(const std::vector<Point>& drawn,
                                  double tolerance);

}  // namespace inkcell::design
