// Closed lists of points that curves are fitted to.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "fit/vectors.hpp"

namespace inkcell::design {

/// A contour as dense points, filled on the left; the last point is followed by
/// the first. [u]
struct Loop {
  std::vector<Point> points;
  /// Unit directions of the contour at the points.
  std::vector<Point> tangents;
  /// Indices of points that are corners, ascending. Their tangents are not
  /// valid.
  std::vector<size_t> corners;
};

/// The vertices of a closed polygon, with points between them at most `spacing`
/// apart.
Loop sample_polygon(const std::vector<Point>& polygon, double spacing);

/// Options of find_corners().
struct CornerOptions {
  /// A corner is rounded over up to this length on both sides. [u]
  double reach = 2;
  /// Least turn of a corner. [radians]
  double turn = 0.2;
  /// Whether points are exact: then the points nearest to corners are moved
  /// there, and none is removed.
  bool is_exact = false;
  /// The distance of a point from the edge, if known. If the two sides of a
  /// corner meet far from the edge, the contour has two corners, the ends of a
  /// blunt tip. [u]
  std::function<double(const Point&)> distance;
};

/// Finds corners: places where the contour turns by more within `reach` than
/// its curvature on both sides explains. A corner is at the intersection of
/// both sides, extrapolated (Itoh and Ohno 1993); the points within `reach` are
/// removed.
void find_corners(const CornerOptions& options, Loop& loop);

}  // namespace inkcell::design
