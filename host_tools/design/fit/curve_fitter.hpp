// Fits the fewest lines and cubics to a loop of points.
#pragma once

#include <functional>
#include <vector>

#include "fit/loop.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

struct FitOptions {
  /// The largest distance of points of the loop from the result, and of the
  /// result from the loop's edge, unless the loop itself is rougher. [u]
  double tolerance = 0.5;
  /// Points at all extremes but the flattest, as type designers set them.
  bool extremes = true;
  /// The distance of a point from the edge, if known better than by the points;
  /// then it is the error of curves. [u]
  std::function<double(const Point&)> distance;
};

/// Tries lines first, keeps corners, makes other joints smooth. Of all
/// divisions at the places of knots.hpp chooses the one with the fewest pieces,
/// then the smallest error (dynamic programming).
gen::Contour fit_loop(const Loop& loop, const FitOptions& options);

/// Fits all loops.
gen::Outline fit_loops(const std::vector<Loop>& loops,
                       const FitOptions& options);

/// Lines and cubics through a list of points that is no loop, within
/// `tolerance` of them; joints are smooth. `ends` gets the index of the point
/// at which each piece ends.
std::vector<gen::Segment> fit_open(const std::vector<Point>& points,
                                   double tolerance,
                                   std::vector<size_t>& ends);

/// The number of lines and curves of an outline, with closing lines and without
/// pieces of no extent.
size_t segment_count(const gen::Outline& outline);

}  // namespace inkcell::design
