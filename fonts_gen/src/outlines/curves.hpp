// Parts, directions and areas of the pieces of contours.
#pragma once

#include <vector>

#include "shape/outline.hpp"

namespace inkcell::gen {

/// The part between the parameters t0 < t1. Ends at 0 and 1 are exact.
Segment part_of(const Segment& segment, double t0, double t1);

Segment reversed(const Segment& segment);

/// Parameters in (0, 1), ascending, where the curve turns back in x or in y.
std::vector<double> turning_points(const Segment& segment);

/// Unit tangents at the ends; zero for a segment without extent.
Point direction_at_start(const Segment& segment);
Point direction_at_end(const Segment& segment);

/// Twice the area between the segment and the origin, counter-clockwise.
double twice_area(const Segment& segment);

}  // namespace inkcell::gen
