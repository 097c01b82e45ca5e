// The area of polygons in cells of a grid.
#pragma once

#include <algorithm>

#include "shape/outline.hpp"

namespace inkcell::gen {

/// Calls `part(row, low, high, is_up)` for the parts of an edge in each row of
/// cells of width 1, from the lowest on. `low.y < high.y`. Level edges have
/// none.
template <typename Part>
void for_rows_of(const Point& a, const Point& b, const Part& part) {
  const bool is_up = a.y <= b.y;
  const Point& low = is_up ? a : b;
  const Point& high = is_up ? b : a;
  const double slope = (high.x - low.x) / (high.y - low.y);
  const auto [left, right] = std::minmax(low.x, high.x);
  Point at = low;
  for (int row = static_cast<int>(low.y); at.y < high.y; ++row) {
    Point next = high;
    if (high.y > row + 1) {
      next = {std::clamp(low.x + (row + 1 - low.y) * slope, left, right),
              static_cast<double>(row + 1)};
    }
    part(row, at, next, is_up);
    at = next;
  }
}

/// Adds what the part of an edge in one row gains: sums of `gains` along the
/// row, from its left end on, are the filled areas of cells. Filled is what
/// lies to the left of edges that go up. Touches the cells from the left end to
/// one after the right end, all of which must be there.
inline void add_gains(const Point& low,
                      const Point& high,
                      bool is_up,
                      double* gains) {
  const double height = is_up ? low.y - high.y : high.y - low.y;
  const auto [left, right] = std::minmax(low.x, high.x);
  const int first = static_cast<int>(left);
  const int last = static_cast<int>(right);
  if (first == last) {
    const double beside = (left + right) / 2 - first;
    gains[first] += height * (1 - beside);
    gains[first + 1] += height * beside;
    return;
  }
  double before = 0;
  for (int x = first; x <= last; ++x) {
    const double from = std::max(left, static_cast<double>(x));
    const double to = std::min(right, x + 1.0);
    // The integral over the column of what lies to its left of the part.
    const double passed = ((from + to) / 2 - left) * (to - from) +
                          (right - left) * (x + 1.0 - to);
    const double area = height * passed / (right - left);
    gains[x] += area - before;
    before = area;
  }
  gains[last + 1] += height - before;
}

}  // namespace inkcell::gen
