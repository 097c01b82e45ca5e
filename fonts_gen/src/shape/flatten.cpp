#include "shape/flatten.hpp"

#include <algorithm>
#include <cmath>

#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// Length of a - 2 b + c.
double second_difference(const Point& a, const Point& b, const Point& c) {
  return std::hypot(a.x - 2 * b.x + c.x, a.y - 2 * b.y + c.y);
}

double second_derivative_bound(const Segment& segment) {
  const Point* p = segment.p;
  switch (segment.kind) {
    case Segment::Kind::quadratic:
      return 2 * second_difference(p[0], p[1], p[2]);
    case Segment::Kind::cubic:
      return 6 * std::max(second_difference(p[0], p[1], p[2]),
                          second_difference(p[1], p[2], p[3]));
    case Segment::Kind::line:
      break;
  }
  return 0;
}

Point between(const Point& a, const Point& b, double t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}

void check(const Segment& segment) {
  for (int i = 0; i <= degree_of(segment); ++i) {
    const Point& p = segment.p[i];
    // Written so that a NaN fails.
    if (!(std::fabs(p.x) <= kCoordinateLimit &&
          std::fabs(p.y) <= kCoordinateLimit)) {
      throw GeometryError(
          GeometryError::Kind::bad_coordinates,
          "a point of the outline is not within " +
              std::to_string(static_cast<int>(kCoordinateLimit)) +
              "/1024 em of the origin");
    }
  }
}

void append(const Point& p, std::vector<Point>& polygon) {
  if (polygon.empty() || !(polygon.back() == p)) {
    polygon.push_back(p);
  }
}

}  // namespace

int chord_count(const Segment& segment, double bound) {
  const double chords =
      std::ceil(std::sqrt(second_derivative_bound(segment) / (8 * bound)));
  return std::max(1, static_cast<int>(chords));
}

// De Casteljau: exact at both ends and stable everywhere.
Point point_on(const Segment& segment, double t) {
  Point p[4];
  std::copy(std::begin(segment.p), std::end(segment.p), p);
  for (int left = degree_of(segment); left > 0; --left) {
    for (int i = 0; i < left; ++i) {
      p[i] = between(p[i], p[i + 1], t);
    }
  }
  return p[0];
}

std::vector<Point> flatten(const Contour& contour, double bound) {
  std::vector<Point> polygon;
  for (const Segment& segment : contour.segments) {
    check(segment);
    append(segment.p[0], polygon);
    const int chords = chord_count(segment, bound);
    for (int i = 1; i < chords; ++i) {
      append(point_on(segment, static_cast<double>(i) / chords), polygon);
    }
    append(end_of(segment), polygon);
  }
  while (polygon.size() > 1 && polygon.front() == polygon.back()) {
    polygon.pop_back();
  }
  return polygon;
}

}  // namespace inkcell::gen
