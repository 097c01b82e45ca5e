// Arithmetic of points.
#pragma once

#include <cmath>

#include "shape/outline.hpp"

namespace inkcell::design {

using gen::Point;

inline Point operator+(const Point& a, const Point& b) {
  return {a.x + b.x, a.y + b.y};
}
inline Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}
inline Point operator*(double k, const Point& a) {
  return {k * a.x, k * a.y};
}
inline double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y;
}
inline double cross(const Point& a, const Point& b) {
  return a.x * b.y - a.y * b.x;
}
inline double length(const Point& a) {
  return std::sqrt(a.x * a.x + a.y * a.y);
}
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
  const Point d = b - a;
  const double squared = dot(d, d);
  double t = squared == 0 ? 0 : dot(p - a, d) / squared;
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  return length(p - a - t * d);
}

}  // namespace inkcell::design
