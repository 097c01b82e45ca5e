// One cubic through two points, as close as it can be to those between.
#pragma once

#include <cstddef>
#include <optional>

#include "fit/vectors.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

/// What a curve is fitted to.
struct Stretch {
  const Point* points = nullptr;  // the curve's ends are the first and the last
  const double* ways = nullptr;   // to each point, from any before: ways_along
  size_t count = 0;               // 2 or more
  /// Direction of the curve at its ends, unit vectors; none: free.
  std::optional<Point> begin;
  std::optional<Point> end;
};

struct FittedCubic {
  gen::Segment segment;
  double worst = 0;  // largest distance of the points from the curve
};

/// Schneider 1990: least squares for the handles, parameters moved by Newton's
/// method, again; from the second round on only distances across the curve
/// count. Where an end is free, so is its handle. Stops early if the curve
/// cannot come within `limit`.
FittedCubic fit_cubic(const Stretch& stretch, double limit);

Point cubic_at(const gen::Segment& cubic, double t);
Point cubic_slope(const gen::Segment& cubic, double t);

}  // namespace inkcell::design
