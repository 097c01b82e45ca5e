// Affine maps of the plane.
#pragma once

#include "shape/outline.hpp"

namespace inkcell::gen {

/// x' = xx x + yx y + dx, y' = xy x + yy y + dy.
struct Affine {
  double xx = 1;
  double xy = 0;
  double yx = 0;
  double yy = 1;
  double dx = 0;
  double dy = 0;

  Point map(double x, double y) const {
    return {xx * x + yx * y + dx, xy * x + yy * y + dy};
  }
  double determinant() const { return xx * yy - xy * yx; }
};

inline bool operator==(const Affine& a, const Affine& b) {
  return a.xx == b.xx && a.xy == b.xy && a.yx == b.yx && a.yy == b.yy &&
         a.dx == b.dx && a.dy == b.dy;
}

/// First `inner`, then `outer`.
inline Affine product(const Affine& outer, const Affine& inner) {
  Affine m;
  m.xx = outer.xx * inner.xx + outer.yx * inner.xy;
  m.xy = outer.xy * inner.xx + outer.yy * inner.xy;
  m.yx = outer.xx * inner.yx + outer.yx * inner.yy;
  m.yy = outer.xy * inner.yx + outer.yy * inner.yy;
  const Point origin = outer.map(inner.dx, inner.dy);
  m.dx = origin.x;
  m.dy = origin.y;
  return m;
}

/// Maps all points of an outline.
inline void map(const Affine& m, Outline& outline) {
  for (Contour& contour : outline.contours) {
    for (Segment& segment : contour.segments) {
      for (Point& p : segment.p) {
        p = m.map(p.x, p.y);
      }
    }
  }
}

}  // namespace inkcell::gen
