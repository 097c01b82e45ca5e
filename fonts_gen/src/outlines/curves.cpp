#include "outlines/curves.hpp"

#include <algorithm>
#include <cmath>

#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// Parameters closer to an end than this count as the end.
constexpr double kEnd = 1e-6;

// The polar form of the curve: its control points over [a, b] are the values
// at a...a, a...b, ..., b...b.
Point polar(const Segment& segment, const double* t) {
  Point p[4];
  std::copy(std::begin(segment.p), std::end(segment.p), p);
  const int degree = degree_of(segment);
  for (int level = 0; level < degree; ++level) {
    for (int i = 0; i < degree - level; ++i) {
      p[i] = (1 - t[level]) * p[i] + t[level] * p[i + 1];
    }
  }
  return p[0];
}

void add_root(double t, std::vector<double>& roots) {
  if (t > kEnd && t < 1 - kEnd) {
    roots.push_back(t);
  }
}

// Zeros of the derivative of a curve with the ordinates v.
void add_turns(const double* v, int degree, std::vector<double>& roots) {
  const double d0 = v[1] - v[0];
  const double d1 = v[2] - v[1];
  if (degree == 2) {
    if (d0 != d1) {
      add_root(d0 / (d0 - d1), roots);
    }
    return;
  }
  const double d2 = v[3] - v[2];
  // d0 (1 - t)^2 + 2 d1 t (1 - t) + d2 t^2 = a t^2 - 2 b t + d0
  const double a = d0 - 2 * d1 + d2;
  const double b = d0 - d1;
  const double inside = b * b - a * d0;
  if (inside < 0) {
    return;
  }
  const double q = b + (b < 0 ? -std::sqrt(inside) : std::sqrt(inside));
  if (q != 0) {
    add_root(d0 / q, roots);
  }
  if (a != 0) {
    add_root(q / a, roots);
  }
}

}  // namespace

Segment part_of(const Segment& segment, double t0, double t1) {
  if (t0 == 0 && t1 == 1) {
    return segment;
  }
  Segment part;
  part.kind = segment.kind;
  const int degree = degree_of(segment);
  for (int i = 0; i <= degree; ++i) {
    double t[3];
    for (int k = 0; k < degree; ++k) {
      t[k] = k < degree - i ? t0 : t1;
    }
    part.p[i] = polar(segment, t);
  }
  if (t0 == 0) {
    part.p[0] = segment.p[0];
  }
  if (t1 == 1) {
    part.p[degree] = segment.p[degree];
  }
  return part;
}

Segment reversed(const Segment& segment) {
  Segment result = segment;
  std::reverse(result.p, result.p + degree_of(segment) + 1);
  return result;
}

std::vector<double> turning_points(const Segment& segment) {
  std::vector<double> roots;
  const int degree = degree_of(segment);
  if (degree > 1) {
    double x[4];
    double y[4];
    for (int i = 0; i <= degree; ++i) {
      x[i] = segment.p[i].x;
      y[i] = segment.p[i].y;
    }
    add_turns(x, degree, roots);
    add_turns(y, degree, roots);
    std::sort(roots.begin(), roots.end());
    const auto close = [](double a, double b) { return b - a < kEnd; };
    roots.erase(std::unique(roots.begin(), roots.end(), close), roots.end());
  }
  return roots;
}

Point direction_at_start(const Segment& segment) {
  for (int i = 1; i <= degree_of(segment); ++i) {
    const Point d = direction(segment.p[i] - segment.p[0]);
    if (!(d == Point{})) {
      return d;
    }
  }
  return {};
}

Point direction_at_end(const Segment& segment) {
  return -1.0 * direction_at_start(reversed(segment));
}

double twice_area(const Segment& segment) {
  const Point* p = segment.p;
  switch (segment.kind) {
    case Segment::Kind::quadratic:
      return (2 * cross(p[0], p[1]) + 2 * cross(p[1], p[2]) +
              cross(p[0], p[2])) /
             3;
    case Segment::Kind::cubic:
      return (6 * cross(p[0], p[1]) + 3 * cross(p[0], p[2]) +
              cross(p[0], p[3]) + 3 * cross(p[1], p[2]) +
              3 * cross(p[1], p[3]) + 6 * cross(p[2], p[3])) /
             10;
    case Segment::Kind::line:
      break;
  }
  return cross(p[0], p[1]);
}

}  // namespace inkcell::gen
