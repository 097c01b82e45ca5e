// Finds places at which a curve through dense points may be divided.
#pragma once

#include <vector>

#include "fit/loop.hpp"

namespace inkcell::design {

/// A place on a stretch of points.
struct Knot {
  size_t at = 0;           // index of the point
  Point tangent;           // unit direction of the contour
  bool is_forced = false;  // every result has a point here
};

/// A stretch without corners inside.
struct SmoothPiece {
  std::vector<Point> points;
  std::vector<Point> tangents;
  bool is_closed = false;  // the last point is the first
};

struct KnotOptions {
  double tolerance = 0.5;  // [u]
  /// Whether extremes in x and y that stand out by some units get a point, with
  /// a horizontal or vertical tangent.
  bool extremes = true;
};

/// First point, last point, extremes, ends of straight parts, and points
/// between them where the contour has turned by some degrees; ascending.
/// Tangents are those of parabolas through the points around.
std::vector<Knot> find_knots(const SmoothPiece& piece,
                             const KnotOptions& options);

}  // namespace inkcell::design
