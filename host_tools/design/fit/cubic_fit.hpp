// Fits a cubic through two points to those between them.
#pragma once

#include <cstddef>
#include <optional>

#include "fit/vectors.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

/// The points that a curve is fitted to.
struct Stretch {
  const Point* points = nullptr;  // the first and the last are the curve's ends
  const double* lengths = nullptr;  // arc_lengths(), with any offset
  size_t count = 0;                 // 2 or more
  /// Direction of the curve at its ends, unit vectors; none: free.
  std::optional<Point> begin;
  std::optional<Point> end;
};

struct FittedCubic {
  gen::Segment segment;
  double worst = 0;  // largest distance of the points from the curve
};

/// Schneider 1990: least squares for the handles and Newton steps for the
/// parameters, in turns; from the second round on only distances across the
/// curve count. At a free end the handle is free. Stops early if the curve
/// cannot get within `limit`.
FittedCubic fit_cubic(const Stretch& stretch, double limit);

Point cubic_at(const gen::Segment& cubic, double t);
Point cubic_slope(const gen::Segment& cubic, double t);

}  // namespace inkcell::design
