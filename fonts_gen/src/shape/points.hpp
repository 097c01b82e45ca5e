// Arithmetic of points and vectors.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "shape/outline.hpp"

namespace inkcell::gen {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kDegree = kPi / 180;  // [radians]
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline Point operator+(const Point& a, const Point& b) {
  return {a.x + b.x, a.y + b.y};
}

inline Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}

inline Point operator*(double s, const Point& p) {
  return {s * p.x, s * p.y};
}

inline bool operator==(const Point& a, const Point& b) {
  return a.x == b.x && a.y == b.y;
}

inline double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y;
}

/// Positive if `b` is to the left of `a`.
inline double cross(const Point& a, const Point& b) {
  return a.x * b.y - a.y * b.x;
}

/// sqrt of the sum of squares: the same on every machine, unlike std::hypot.
inline double length(const Point& p) {
  return std::sqrt(dot(p, p));
}

/// The vector scaled to length 1; zero for the zero vector.
inline Point direction(const Point& p) {
  const double size = length(p);
  return size > 1e-9 ? (1 / size) * p : Point{};
}

inline Point middle(const Point& a, const Point& b) {
  return 0.5 * (a + b);
}

/// The line a + t d, t = 0..1.
struct Chord {
  Point a;
  Point d;
  double size = 0;  // |d|^2

  Point at(double t) const { return a + t * d; }

  /// The t of the point that is nearest to `p`.
  double nearest(const Point& p) const {
    return size > 0 ? std::clamp(dot(p - a, d) / size, 0.0, 1.0) : 0;
  }

  double squared_distance(const Point& p) const {
    const Point e = p - a - nearest(p) * d;
    return dot(e, e);
  }
};

inline Chord chord_between(const Point& a, const Point& b) {
  const Point d = b - a;
  return {a, d, dot(d, d)};
}

/// The point at `t` of the quadratic from `a` to `b`, by its polynomial.
inline Point on_quadratic(const Point& a,
                          const Point& control,
                          const Point& b,
                          double t) {
  const double s = 1 - t;
  return (s * s) * a + (2 * s * t) * control + (t * t) * b;
}

inline double squared_distance_to_segment(const Point& p,
                                          const Point& a,
                                          const Point& b) {
  return chord_between(a, b).squared_distance(p);
}

}  // namespace inkcell::gen
