#include "outlines/outline_steps.hpp"

#include <cstdlib>
#include <string>

#include "shape/outline.hpp"

namespace inkcell::gen {
namespace {

// i16 font units on the finest grid, 1/16 of a font unit.
constexpr int kMostCoordinate = 1 << 19;

constexpr int kMostPoints = 65535;

bool is_off(const GridPoint& point) {
  return point.kind == PointKind::off_curve;
}

bool fits(int dx, int dy) {
  return step_bits(dx) <= kMostStepBits && step_bits(dy) <= kMostStepBits;
}

GridPoint half_way(const GridPoint& a, const GridPoint& b, PointKind kind) {
  return {(a.x + b.x) >> 1, (a.y + b.y) >> 1, kind};
}

// Splits the curve of control point `i` in halves. Implied end points become
// explicit.
std::vector<GridPoint> halve_curve(const std::vector<GridPoint>& points,
                                   size_t i) {
  const GridPoint& control = points[i];
  const GridPoint& before = points[i - 1];
  const GridPoint& after = points[(i + 1) % points.size()];
  std::vector<GridPoint> result(points.begin(),
                                points.begin() + static_cast<long>(i));
  const GridPoint begin =
      is_off(before) ? half_way(before, control, PointKind::smooth) : before;
  const GridPoint end =
      is_off(after) ? half_way(control, after, PointKind::smooth) : after;
  if (is_off(before)) {
    result.push_back(begin);
  }
  result.push_back(half_way(begin, control, PointKind::off_curve));
  result.push_back(half_way(control, end, PointKind::off_curve));
  if (is_off(after)) {
    result.push_back(end);
  }
  result.insert(result.end(), points.begin() + static_cast<long>(i) + 1,
                points.end());
  return result;
}

// Splits the line or curve that the step from point i - 1 to point i is part
// of.
std::vector<GridPoint> halve(std::vector<GridPoint> points, size_t i) {
  if (is_off(points[i])) {
    return halve_curve(points, i);
  }
  if (is_off(points[i - 1])) {
    return halve_curve(points, i - 1);
  }
  points.insert(points.begin() + static_cast<long>(i),
                half_way(points[i - 1], points[i], PointKind::smooth));
  return points;
}

std::vector<GridPoint> with_short_steps(std::vector<GridPoint> points) {
  size_t i = 1;
  while (i < points.size()) {
    if (fits(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y)) {
      ++i;
    } else {
      points = halve(std::move(points), i);
      // The step before may have been a part of the same curve.
      i = i > 1 ? i - 1 : 1;
    }
  }
  return points;
}

void check_coordinates(const MinimalContour& contour) {
  for (const GridPoint& point : contour.points) {
    if (std::abs(point.x) > kMostCoordinate ||
        std::abs(point.y) > kMostCoordinate) {
      throw GeometryError(
          GeometryError::Kind::too_complex,
          "the point " + std::to_string(point.x) + ", " +
              std::to_string(point.y) + " of the outline is farther than " +
              std::to_string(kMostCoordinate) + " grid units from the origin");
    }
  }
}

}  // namespace

GridPosition record_start(int x_min, int y_min, int grid_shift) {
  if (grid_shift < 0) {
    return {x_min * (1 << -grid_shift), y_min * (1 << -grid_shift)};
  }
  return {x_min >> grid_shift, y_min >> grid_shift};
}

std::vector<OutlineStep> outline_steps(const MinimalOutline& outline,
                                       GridPosition start) {
  std::vector<OutlineStep> steps;
  GridPosition at = start;
  for (const MinimalContour& contour : outline.contours) {
    if (contour.points.empty()) {
      continue;
    }
    check_coordinates(contour);
    const GridPoint& first = contour.points.front();
    if (!fits(first.x - at.x, first.y - at.y)) {
      throw GeometryError(
          GeometryError::Kind::too_complex,
          "a contour begins " + std::to_string(first.x - at.x) + ", " +
              std::to_string(first.y - at.y) +
              " grid units from the point before it; -16384..16383 fit");
    }
    for (const GridPoint& point : with_short_steps(contour.points)) {
      const bool is_first = steps.empty() || steps.back().kind == WordKind::end;
      steps.push_back(
          {is_first ? WordKind::corner : static_cast<WordKind>(point.kind),
           point.x - at.x, point.y - at.y});
      at = {point.x, point.y};
    }
    steps.push_back({WordKind::end, 0, 0});
  }
  if (point_count(steps) > kMostPoints) {
    throw GeometryError(GeometryError::Kind::too_complex,
                        "the outline has " +
                            std::to_string(point_count(steps)) + " points; " +
                            std::to_string(kMostPoints) + " fit");
  }
  return steps;
}

int point_count(const std::vector<OutlineStep>& steps) {
  // An `end` stands for the closing point of its contour.
  return static_cast<int>(steps.size());
}

}  // namespace inkcell::gen
