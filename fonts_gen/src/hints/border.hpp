// The border of a glyph as chords, and its ink along straight lines.
#pragma once

#include <vector>

#include "shape/outline.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {

/// The axis of a position: heights are on the y axis, and their edges run along
/// x.
enum class Axis { x, y };

inline double position(const Point& point, Axis axis) {
  return axis == Axis::x ? point.x : point.y;
}

inline double along(const Point& point, Axis axis) {
  return axis == Axis::x ? point.y : point.x;
}

/// [u]
struct Interval {
  double low = 0;
  double high = 0;

  double length() const { return high - low; }
  double middle() const { return (low + high) / 2; }
};

using Intervals = std::vector<Interval>;

/// The length that both have in common, 0 if none.
double overlap(const Interval& a, const Interval& b);

/// The same, summed over all pairs.
double overlap(const Intervals& a, const Intervals& b);

double total_length(const Intervals& intervals);

class Border {
 public:
  /// The contours of `outline` must not cross or overlap; the filled side is on
  /// their left. Curves become chords.
  explicit Border(const Outline& outline);

  /// Closed polylines; the first point is not repeated, and no point equals the
  /// next.
  const std::vector<std::vector<Point>>& lines() const { return lines_; }

  bool empty() const { return lines_.empty(); }

  /// All zero if the border is empty.
  const Box& box() const { return box_; }

  /// The ink on the line at position `at` of `axis`, ascending.
  Intervals ink_at(Axis axis, double at) const;

 private:
  std::vector<std::vector<Point>> lines_;
  Box box_;
};

}  // namespace inkcell::gen
