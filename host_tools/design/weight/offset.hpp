// Contours moved outwards or inwards, point by point.
#pragma once

#include <vector>

#include "fit/vectors.hpp"
#include "model/glyph.hpp"
#include "shape/shape.hpp"

namespace inkcell::design {

/// How far edges move outwards, positive away from ink: `across` where they are
/// upright, `up` where they are level, in between by their direction. [u]
struct Growth {
  double across = 0;
  double up = 0;

  /// The movement along the unit normal `n`.
  double along(const Point& n) const {
    return across * n.x * n.x + up * n.y * n.y;
  }
  /// The movement of the point whose unit normal is `n`: the edge of a moved
  /// curve is the envelope of its moved tangents.
  Point of(const Point& n) const {
    const double slide = 2 * (across - up) * n.x * n.y;
    return along(n) * n + slide * Point{n.y, -n.x};
  }
};

/// A line or curve of a contour, and the points that it is made of.
struct Piece {
  gen::Segment curve;  // [u]
  std::vector<size_t> controls;
  std::vector<size_t> ends;  // none where two controls imply its end
  double extra = 0;          // movement of its middle in addition to Growth [u]
};

/// The pieces of a closed contour whose points are in u; none of an open one.
std::vector<Piece> pieces_of(const PointContour& contour);

/// The unit normal of a piece at `t`, away from ink, which is on its left
/// unless `is_clockwise`.
Point normal_at(const gen::Segment& curve, double t, bool is_clockwise);

/// The contour with the same points, of the same kinds, moved. Corners are
/// where both edges meet if they are continued; handles keep their directions
/// where the joint is smooth, and fit the moved curve.
PointContour moved(const PointContour& contour,
                   const std::vector<Piece>& pieces,
                   const Growth& growth,
                   bool is_clockwise);

}  // namespace inkcell::design
