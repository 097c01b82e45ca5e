// How much area a pixel can gain or lose, wherever it lies.
#pragma once

#include <vector>

#include "shape/shape.hpp"

namespace inkcell::gen {

using Polygons = std::vector<std::vector<Point>>;

/// A pixel that differs from the source.
struct MovedPixel {
  double share = 0;  // of its area, 0..1
  Point centre_u;
};

/// What an outline fills and its source does not, and the other way round.
class MovedArea {
 public:
  /// Throws GeometryError.
  MovedArea(const Shape& source, const Shape& drawn);

  /// Finds an upper bound of the share of a pixel of this size [px/em] by which
  /// the areas differ, at any position. As a rule the largest difference is 3 %
  /// less. Of the bounds beyond `limit` the largest one of each square as wide
  /// as a pixel is added to `beyond`. Returns `known` if none is larger.
  ///
  /// `strays`: one or several cases, the worst of which counts. Each is a list
  /// of closed polygons that are added to the drawn area where they run
  /// counter-clockwise, and taken away from it where they run clockwise.
  MovedPixel worst_pixel(int px,
                         const std::vector<Polygons>& strays,
                         double limit,
                         const MovedPixel& known,
                         std::vector<MovedPixel>& beyond) const;

 private:
  Polygons gained_;
  Polygons lost_;
};

}  // namespace inkcell::gen
