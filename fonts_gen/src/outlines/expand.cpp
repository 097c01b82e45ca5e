#include "outlines/expand.hpp"

#include <cmath>

#include "outlines/curves.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {

Contour expand(const MinimalContour& minimal, double u_per_grid) {
  const std::vector<GridPoint>& points = minimal.points;
  const size_t n = points.size();
  const auto at = [&](size_t i) {
    return u_per_grid * Point{static_cast<double>(points[i % n].x),
                              static_cast<double>(points[i % n].y)};
  };
  const auto off = [&](size_t i) {
    return points[i % n].kind == PointKind::off_curve;
  };
  Contour contour;
  Point pen = at(0);
  for (size_t i = 1; i <= n; ++i) {
    if (!off(i)) {
      contour.segments.push_back(line_segment(pen, at(i)));
    } else {
      Segment curve;
      curve.kind = Segment::Kind::quadratic;
      curve.p[0] = pen;
      curve.p[1] = at(i);
      curve.p[2] = off(i + 1) ? middle(at(i), at(i + 1)) : at(i + 1);
      contour.segments.push_back(curve);
      i += off(i + 1) ? 0u : 1u;
    }
    pen = end_of(contour.segments.back());
  }
  return contour;
}

Outline expand(const MinimalOutline& outline,
               int units_per_em,
               int grid_shift) {
  const double u_per_grid = std::ldexp(1024.0 / units_per_em, grid_shift);
  Outline result;
  for (const MinimalContour& contour : outline.contours) {
    result.contours.push_back(expand(contour, u_per_grid));
  }
  return result;
}

}  // namespace inkcell::gen
