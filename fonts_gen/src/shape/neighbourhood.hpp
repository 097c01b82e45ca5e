// The edges of a shape that matter inside a square.
#pragma once

#include <cstddef>
#include <vector>

#include "shape/shape.hpp"

namespace inkcell::gen {

/// An axis-parallel square: lower left corner and width. [u]
struct Square {
  double x = 0;
  double y = 0;
  double size = 0;
};

/// The edges of a shape that can be nearest to a point of a square. The list of
/// a part is found from the list of the whole, so each level of a quadtree
/// costs less. Refers to the shape, which must outlive it.
class Neighbourhood {
 public:
  /// `shape` must not be empty.
  Neighbourhood(const Shape& shape, const Square& square);

  /// The list for `part`, which must lie in square().
  Neighbourhood part(const Square& part) const;

  const Square& square() const { return square_; }
  size_t edge_count() const { return lines_.size(); }

  /// The same as Shape::distance for any (x, y) in square().
  double distance(double x, double y) const;

  /// Distances at the `count` points (x + i * step, y), all in square(), to
  /// out[0..count). Faster than single calls.
  void distances(
      double x, double y, double step, size_t count, double* out) const;

  /// Least distance between the square and the border. [u] 0 if they meet.
  double clearance() const;

 private:
  Neighbourhood() = default;

  // An edge is a + t d, t = 0..1; inverse = 1 / |d|^2.
  struct Line {
    double ax = 0;
    double ay = 0;
    double dx = 0;
    double dy = 0;
    double inverse = 0;
    double squared_distance(double x, double y) const;
  };

  const Shape* shape_ = nullptr;
  Square square_;
  std::vector<Line> lines_;
};

}  // namespace inkcell::gen
