// The filled area of a glyph and the exact signed distance to its border.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shape/outline.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {

/// A rectangle. [u]
struct Box {
  double x0 = 0;
  double y0 = 0;
  double x1 = 0;
  double y1 = 0;

  /// Grows to hold a point.
  void add(const Point& p) {
    x0 = std::min(x0, p.x);
    y0 = std::min(y0, p.y);
    x1 = std::max(x1, p.x);
    y1 = std::max(y1, p.y);
  }
};

/// The box of no points.
inline constexpr Box kNoBox = {kInfinity, kInfinity, -kInfinity, -kInfinity};

Box box_of(const std::vector<std::vector<Point>>& lines);

/// A straight piece of the border. The filled side is on its left.
struct Edge {
  Point a;
  Point b;
};

/// The union of all that an outline fills, as a polygon.
///
/// Curves become chords (kFlatteningBound), coordinates are rounded to 1/65536
/// u, and contours are united under the non-zero rule. So every edge has filled
/// area on one side only, and edges inside the shape do not count. Immutable;
/// any number of threads may query it.
class Shape {
 public:
  /// Drops contours that fill nothing, and islands and holes of less than 4 u^2
  /// with a mean width of less than 1/8 u.
  ///
  /// Throws GeometryError::bad_coordinates.
  explicit Shape(const Outline& outline);

  bool empty() const { return edges_.empty(); }

  /// Smallest box around the filled area; all zero if there is none.
  const Box& box() const { return box_; }

  const std::vector<Edge>& edges() const { return edges_; }

  /// The distance from (x, y) to the border, positive inside. [u] Exact for the
  /// polygon but for rounding of doubles. -infinity for an empty shape.
  double distance(double x, double y) const;

  /// Whether (x, y) is filled. On the border: either.
  bool inside(double x, double y) const;

  /// Finds the x at which the line at height `y` meets the border, ascending,
  /// an even number: filled between the first and the second, and so on.
  /// Replaces the content of `out`. An edge counts for min(a.y, b.y) <= y <
  /// max(a.y, b.y).
  void crossings(double y, std::vector<double>& out) const;

 private:
  // A box around edges [first, first + count); children of node i are 2i + 1
  // and 2i + 2.
  struct Branch {
    Box box;
    uint32_t first = 0;
    uint32_t count = 0;
  };

  void build_tree(size_t node, uint32_t first, uint32_t count);
  void build_rows();

  std::vector<Edge> edges_;
  std::vector<Branch> tree_;
  // Edges that touch the horizontal band i of height row_height_ are
  // row_edges_[row_starts_[i] .. row_starts_[i + 1]).
  std::vector<uint32_t> row_starts_;
  std::vector<uint32_t> row_edges_;
  double row_height_ = 1;
  Box box_;
};

}  // namespace inkcell::gen
