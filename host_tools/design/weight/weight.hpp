// Bolder and lighter outlines with the same points.
#pragma once

#include <vector>

#include "weight/offset.hpp"
#include "weight/zones.hpp"

namespace inkcell::design {

struct WeightChange {
  Growth growth;              // of edges: half of what stems and bars grow by
  double squeeze = 0;         // the part of it that counters give, 0..1
  Heights heights;            // that stay: baseline, x-height, ...
  bool is_clockwise = false;  // contours around ink
};

/// The contours of one glyph, in u, with other weight. Their numbers and kinds
/// of points stay, and the heights and the left end of the ink; edges between
/// which a counter would close move less. Stems and bars of any direction are
/// measured in both outlines by rays to the opposite edge, and what is missing
/// is added. Throws gen::GeometryError.
std::vector<PointContour> with_weight(const std::vector<PointContour>& contours,
                                      const WeightChange& change);

/// The filled shape of contours in u.
gen::Shape shape_of(const std::vector<PointContour>& contours);

}  // namespace inkcell::design
