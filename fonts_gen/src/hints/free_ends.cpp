#include "hints/free_ends.hpp"

#include <algorithm>
#include <cmath>

#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// Extremes this near to a bar belong to it. [u]
constexpr double kBarReach = 15;

// Ends at nearly the same height on the same side count as one. [u]
constexpr double kSameEnd = 4;

bool is_between_bars(double y, const std::vector<Stroke>& bars) {
  bool below = false;
  bool above = false;
  for (const Stroke& bar : bars) {
    if (y > bar.low - kBarReach && y < bar.high + kBarReach) {
      return false;
    }
    below |= bar.high < y;
    above |= bar.low > y;
  }
  return below && above;
}

// Whether the border turns left at [first, last], all at one height: at a
// corner, or along a flat part. The filled side is on the left.
bool is_convex(const Point& before,
               const Point& first,
               const Point& last,
               const Point& after,
               bool is_lowest) {
  if (first == last) {
    return cross(first - before, after - last) > 0;
  }
  return (last.x > first.x) == is_lowest;
}

}  // namespace

std::vector<FreeEnd> find_free_ends(const Border& border,
                                    const std::vector<Stroke>& bars) {
  std::vector<FreeEnd> ends;
  const auto add = [&](const FreeEnd& end) {
    const bool is_known =
        std::any_of(ends.begin(), ends.end(), [&end](const FreeEnd& other) {
          return other.rises == end.rises &&
                 std::abs(other.y - end.y) < kSameEnd;
        });
    if (!is_known) {
      ends.push_back(end);
    }
  };
  for (const std::vector<Point>& line : border.lines()) {
    const size_t n = line.size();
    for (size_t i = 0; i < n; ++i) {
      const Point& before = line[(i + n - 1) % n];
      const Point& first = line[i];
      size_t flat = 0;
      while (flat < n && line[(i + flat + 1) % n].y == first.y) {
        ++flat;
      }
      const Point& last = line[(i + flat) % n];
      const Point& after = line[(i + flat + 1) % n];
      const bool is_lowest = before.y > first.y && after.y > first.y;
      const bool is_highest = before.y < first.y && after.y < first.y;
      if ((is_lowest || is_highest) &&
          is_convex(before, first, last, after, is_lowest) &&
          is_between_bars(first.y, bars)) {
        add({first.y, is_highest});
      }
    }
  }
  std::sort(ends.begin(), ends.end(), [](const FreeEnd& a, const FreeEnd& b) {
    return a.y != b.y ? a.y < b.y : a.rises < b.rises;
  });
  return ends;
}

}  // namespace inkcell::gen
