// A glyph as an outline font stores it: few points, on the font's grid.
#pragma once

#include <cstdint>
#include <vector>

namespace inkcell::gen {

/// The values are those of the code table.
enum class PointKind : uint8_t {
  off_curve,  // control point of a quadratic
  smooth,     // on the curve, the tangent turns by less than 8 degrees
  corner,     // on the curve
};

/// A point of a contour. [grid units] y up.
struct GridPoint {
  int x;
  int y;
  PointKind kind;
};

/// A closed curve of lines and quadratics, filled on its left.
///
/// The first point is a corner. Between two consecutive control points there is
/// an implied smooth point midway. The contour closes from its last point to
/// the first: with a line if the last is on the curve, else with a quadratic.
struct MinimalContour {
  std::vector<GridPoint> points;
};

/// Contours neither cross nor overlap; outer ones run counter-clockwise, holes
/// clockwise.
struct MinimalOutline {
  std::vector<MinimalContour> contours;
};

}  // namespace inkcell::gen
