// Blends of contours: their union with fillets.
#pragma once

#include <vector>

#include "model/glyph.hpp"

namespace inkcell::design {

/// The union of `a` and `b` with a fillet of `radius` font units, as
/// Combination::blend. `u_per_unit` is 1024 by the units an em.
///
/// Beyond the fillets the points of both stay; new points are whole units.
/// Counter-clockwise around ink. Throws gen::GeometryError or Error.
std::vector<PointContour> blended(const std::vector<PointContour>& a,
                                  const std::vector<PointContour>& b,
                                  double radius,
                                  double u_per_unit);

}  // namespace inkcell::design
