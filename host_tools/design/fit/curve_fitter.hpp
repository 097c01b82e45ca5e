// The fewest lines and cubics for a loop of points.
#pragma once

#include <functional>
#include <vector>

#include "fit/loop.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

struct FitOptions {
  /// No point of the loop is farther from the result than this, and none of the
  /// result farther from the loop's edge, except where the loop itself is
  /// rougher. [u]
  double tolerance = 0.5;
  /// Points at all extremes but the flattest, as type designers set them.
  bool extremes = true;
  /// Distance of a point from the edge, if something knows it better than the
  /// points do: the error of curves is taken from it. [u]
  std::function<double(const Point&)> distance;
};

/// Lines are tried first, corners are kept, other joints are smooth. Of all
/// divisions at the places that knots.hpp finds, the one with the fewest pieces
/// is chosen, and of those the truest (dynamic programming).
gen::Contour fit_loop(const Loop& loop, const FitOptions& options);

/// All loops.
gen::Outline fit_loops(const std::vector<Loop>& loops,
                       const FitOptions& options);

/// Lines and cubics through a list of points that is no loop, within
/// `tolerance` of them; joints are smooth. `ends` gets the index of the point
/// at which each piece ends.
std::vector<gen::Segment> fit_open(const std::vector<Point>& points,
                                   double tolerance,
                                   std::vector<size_t>& ends);

/// Lines and curves of an outline; a line that closes a contour counts, a piece
/// without extent does not.
size_t segment_count(const gen::Outline& outline);

}  // namespace inkcell::design
