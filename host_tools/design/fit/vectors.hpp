// Arithmetic of points in addition to shape/points.hpp.
#pragma once

#include <cmath>
#include <vector>

#include "shape/points.hpp"

namespace inkcell::design {

using gen::cross;
using gen::dot;
using gen::length;
using gen::Point;
using gen::operator+;
using gen::operator-;
using gen::operator*;

/// Zero stays zero.
inline Point unit(const Point& a) {
  const double l = length(a);
  return l == 0 ? a : Point{a.x / l, a.y / l};
}
inline bool same(const Point& a, const Point& b) {
  return a.x == b.x && a.y == b.y;
}
/// Angle from a to b, -pi..pi.
inline double turn(const Point& a, const Point& b) {
  return std::atan2(cross(a, b), dot(a, b));
}
/// Distance of p from the line segment a b.
inline double distance_to_piece(const Point& p,
                                const Point& a,
                                const Point& b) {
  return std::sqrt(gen::squared_distance_to_segment(p, a, b));
}
/// The length of the polyline up to each point.
inline std::vector<double> arc_lengths(const std::vector<Point>& points) {
  std::vector<double> lengths(points.size());
  for (size_t i = 1; i < points.size(); ++i) {
    lengths[i] = lengths[i - 1] + length(points[i] - points[i - 1]);
  }
  return lengths;
}

}  // namespace inkcell::design
