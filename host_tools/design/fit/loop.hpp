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
  /// Indices of points that are corners, ascending. The tangent there is of no
  /// use.
  std::vector<size_t> corners;
};

/// The vertices of a closed polygon, and points at most `spacing` apart between
/// them.
Loop sample_polygon(const std::vector<Point>& polygon, double spacing);

/// How corners are found.
struct CornerOptions {
  /// A corner is rounded by up to this on both sides. [u]
  double reach = 2;
  /// Least turn of a corner. [radians]
  double turn = 0.2;
  /// Whether points are exact: those nearest to the corners become them, and
  /// none gives way.
  bool is_exact = false;
  /// Distance of a point from the edge, if something knows it: where the two
  /// sides of a corner meet far from the edge, the contour has two corners, the
  /// ends of a blunt tip. [u]
  std::function<double(const Point&)> distance;
};

/// Finds corners: where the contour turns by more within `reach` than its
/// curvature on both sides explains. A corner lies where the curves of both
/// sides meet if they are continued (Itoh and Ohno 1993); the points within
/// `reach` give way to it.
void find_corners(const CornerOptions& options, Loop& loop);

}  // namespace inkcell::design
