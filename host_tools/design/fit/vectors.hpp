// More arithmetic of points than shape/points.hpp has.
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
/// Distance of p from the line piece a b.
inline double distance_to_piece(const Point& p,
                                const Point& a,
                                const Point& b) {
  return std::sqrt(gen::squared_distance_to_segment(p, a, b));
}
/// The length of the polygon from the first point to each.
inline std::vector<double> ways_along(const std::vector<Point>& points) {
  std::vector<double> ways(points.size());
  for (size_t i = 1; i < points.size(); ++i) {
    ways[i] = ways[i - 1] + length(points[i] - points[i - 1]);
  }
  return ways;
}

}  // namespace inkcell::design
