// The walk along the contours of an outline, for whoever paints or keeps them.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "rows/band.hpp"

namespace inkcell::detail {

// Cuts a line into 2^n parts that are shorter than `limit` in both directions,
// and shows them one after the other: part(from, to).
template <typename Part>
__attribute__((always_inline)) inline void cut_line(PixelPoint from,
                                                    const PixelPoint& to,
                                                    int32_t limit,
                                                    const Part& part) noexcept {
  const int32_t dx = to.x - from.x;
  const int32_t dy = to.y - from.y;
  const int32_t length = max(abs(dx), abs(dy));
  uint32_t halvings = 0;
  // Roundings add up to less than a 256th a part, all of them in the last one.
  while (__builtin_expect(length >> halvings > limit - (1 << halvings), 0)) {
    ++halvings;
  }
  // One call of `part` is smaller, two are faster.
  PixelPoint at = from;
  for (int32_t left = (1 << halvings) - (kIsSmall ? 0 : 1); left != 0; --left) {
    PixelPoint next = {at.x + (dx >> halvings), at.y + (dy >> halvings)};
    if (kIsSmall && left == 1) {
      next = to;
    }
    part(at, next);
    at = next;
  }
  if (!kIsSmall) {
    part(at, to);
  }
}

// Shows a visitor the edges that points lead to, relative to the band. Points
// come in portions: `edge`, three points, and `is_bent` stay from one to the
// next. Begins with {0, 0}, {0, 0} and false.
//
//   visitor.start(at)                   a contour begins there
//   visitor.take(edge, is_bent, kind)   the line from edge[0] to edge[2], or a
//                                       curve whose control point is edge[1].
//       kind   that of its end; kOffCurve between two control points, where the
//              visitor may move edge[2], and with it the next curve's begin
//   Visitor::kNearRows                  only edges that touch rows, or may as
//                                       the second of a pair, are of interest
//
// A curve's subdivision is the visitor's own: areas move joints outwards so
// that chords hold as much as the curve (area_painter.cpp), rows of distances
// follow parabolas and halve only what bends back (distance_painter.cpp), wide
// ones need tangents (wide_painter.cpp), and fields the fewest chords
// (polyline.cpp).
template <typename Visitor>
inline void walk_contours(const Band& band,
                          PixelPoint* edge,
                          bool& is_bent_before,
                          const ScreenPoint* points,
                          const ScreenPoint* end,
                          Visitor& visitor) noexcept {
  bool is_bent = is_bent_before;
  const bool is_whole = band.is_whole;
  for (; points != end; ++points) {
    const int32_t x = points->x_q8 - band.x_q8;
    const int32_t y = points->y_q8() - band.y_q8;
    const uint32_t kind = points->kind();
    if (kind == kOffCurve) {
      if (is_bent) {
        edge[2].x = (edge[1].x + x) >> 1;
        edge[2].y = (edge[1].y + y) >> 1;
        visitor.take(edge, true, kOffCurve);
        edge[0] = edge[2];
      }
      edge[1].x = x;
      edge[1].y = y;
      is_bent = true;
      continue;
    }
    if (kind == kStart) {
      visitor.start({x, y});
    } else {
      edge[2].x = x;
      edge[2].y = y;
      visitor.take(edge, is_bent, kind);
    }
    edge[0].x = x;
    edge[0].y = y;
    is_bent = false;
    if (Visitor::kNearRows && !is_whole && is_outside(band, y)) {
      points = skip_outside(band, points, end);
      edge[0] = {points->x_q8 - band.x_q8, points->y_q8() - band.y_q8};
    }
  }
  is_bent_before = is_bent;
}

}  // namespace inkcell::detail
