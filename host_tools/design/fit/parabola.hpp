// Curves of second degree through points.
#pragma once

#include <vector>

#include "fit/vectors.hpp"

namespace inkcell::design {

/// x and y as polynomials of second degree of the arc length.
struct Parabola {
  Point c[3];

  Point at(double s) const { return c[0] + s * (c[1] + s * c[2]); }
  Point slope(double s) const { return c[1] + 2 * s * c[2]; }
};

/// Least squares through `points` at the arc lengths `s`; a line if there are
/// too few points.
Parabola fit_parabola(const std::vector<double>& s,
                      const std::vector<Point>& points);

}  // namespace inkcell::design
