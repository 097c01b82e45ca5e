// Distances to an outline, only where the ramp of the filter is (Perry and
// Frisken, section 3.3.2, in bands of rows).
//
// A pixel's byte holds the nearness to the edge in bits 1 to 7, 254 on the edge
// and 0 from half a pixel on, and in bit 0 whether a contour passes between it
// and the pixel to its left: an odd number of such bits up to a pixel means
// that it is inside. Nearness only grows and bits only change, so that neither
// the order of edges nor the cut into bands matters.
//
// An edge is walked along its longer axis. Where it crosses a row (or column),
// with a slope of at most 1.73, all pixels within half a pixel of it are the
// two beside the crossing:
//
//        f     1 - f             distances: f cos a and (1 - f) cos a,
//      o-----x-------o           a = the angle between the edge and the axis
//           /
//
// Curves are walked as cubics or parabolas along their axis: one reciprocal a
// piece, a few additions a row. Only near the ends of an edge the foot of a
// pixel may lie beyond it. Such rows are tips: what is beyond a smooth end is
// as far away as the end; a corner has a vertex of its own.
//
// Over 400 lines: one painter, whose loops are inlined into each other.
#include "rows/distance_painter.hpp"

#include "base/math.hpp"
#include "rows/edge_rows.hpp"
#include "rows/reciprocal.hpp"

namespace inkcell {
namespace detail {
namespace {

// An edge of slope 3/8 or more has tips. A tip is a row near an end of the edge
// where that end may be the nearest point to a pixel: a row at most kBeyondEnd
// beyond the end, or at most kWithinEnd before it. The foot of a pixel lies up
// to half a pixel times the sine of the slope away from its row. [Q16; px, Q8]
constexpr int32_t kSlanted = 3 << 13;
constexpr int32_t kBeyondEnd = 100;
constexpr int32_t kWithinEnd = 56;

// Edges that bend more, with a radius of 1 px or less, and shorter curves,
// which may turn by any angle, are looked at closely in each row: there the
// nearest point lies where the edge has left its tangent. Slopes at their ends
// are rough: 1/8 counts. [Q16; px, Q8; Q16]
constexpr int32_t kSharp = 1 << 15;  // of half the bend
constexpr int32_t kShort = 64;
constexpr int32_t kSlantedIfSharp = 1 << 13;

// Curves that are shorter or longer along their axis are parabolas: short ones
// need no more, and of long ones the jerk has too few bits. [px, Q8]
constexpr int32_t kLeastCubic = 640;
constexpr int32_t kMostCubic = 16 << 8;

// The pixel nearest to a vertex: no other one lies within half a pixel.
__attribute__((noinline)) void paint_vertex(const Band& band,
                                            int32_t x,
                                            int32_t y) noexcept {
  const int32_t row = (y + 128) >> 8;
  const int32_t column = (x + 128) >> 8;
  if (static_cast<uint32_t>(row) >= static_cast<uint32_t>(band.rows) ||
      static_cast<uint32_t>(column) > static_cast<uint32_t>(band.last_column)) {
    return;
  }
  const int32_t length = doubled_length(x - column * 256, y - row * 256);
  approach(band.row(row) + column, 254 - (length & ~1));
}

__attribute__((noinline)) void paint_vertical(const Band& band,
                                              int32_t x,
                                              int32_t from,
                                              int32_t to) noexcept {
  const int32_t first = max((min(from, to) >> 8) + 1, 0);
  int32_t count = min((max(from, to) >> 8) + 1, band.rows) - first;
  const int32_t column = x >> 8;
  if (count <= 0 || column > band.last_column) {
    return;
  }
  const int32_t stride = band.stride;
  uint8_t* pixel = band.row(first);
  if (column < 0) {
    do {
      pixel[0] ^= 1;
      pixel += stride;
    } while (--count != 0);
    return;
  }
  pixel += column;
  const int32_t before = 254 - (x & 255) * 2;
  const int32_t behind = (x & 255) * 2 - 256;
  if (before <= 0) {
    do {
      int32_t old = pixel[1];
      if (old < behind) {
        old = behind | (old & 1);
      }
      pixel[1] = static_cast<uint8_t>(old ^ 1);
      pixel += stride;
    } while (--count != 0);
  } else {
    do {
      approach(pixel, before);
      pixel[1] ^= 1;
      if (behind > 0) {
        approach(pixel + 1, behind);
      }
      pixel += stride;
    } while (--count != 0);
  }
}

__attribute__((noinline)) void paint_horizontal(const Band& band,
                                                int32_t y,
                                                int32_t from,
                                                int32_t to) noexcept {
  const int32_t first = max((min(from, to) >> 8) + 1, 0);
  const int32_t count =
      min((max(from, to) >> 8) + 1, band.last_column + 1) - first;
  const int32_t row = y >> 8;
  if (count <= 0 ||
      static_cast<uint32_t>(row + 1) > static_cast<uint32_t>(band.rows)) {
    return;
  }
  int32_t nearness = 254 - (y & 255) * 2;
  uint8_t* pixel = band.row(row) + first;
  for (int32_t side = 0; side < 2; ++side) {
    if (nearness > 0) {
      uint8_t* at = pixel;
      uint8_t* const end = pixel + count;
      do {
        approach(at, nearness);
      } while (++at != end);
    }
    pixel += band.stride;
    nearness = -2 - nearness;
  }
}

inline bool may_be_cubic(int32_t d_along) noexcept {
  return d_along >= kLeastCubic && d_along < kMostCubic;
}

// Whether a parabola strays by more than about 5/256 px, a tenth of e times the
// bend, e = dd_along / d_along.
inline bool is_cubic(int32_t bend, int32_t d_along, int32_t dd_along) noexcept {
  return may_be_cubic(d_along) && 3 * abs(dd_along) <= d_along &&
         bend * abs(dd_along) > 48 * d_along;
}

// What e times the bend must not pass, times the length: of cubics, which stray
// by up to 0.06 e^2 of the bend, 80/256 px over e, with e rounded up to 1/8,
// 1/4 or 1/2; of parabolas less where e is above 1/2, as their slope at an end
// is far from the curve's, and of those whose halves are cubics. [px, Q8]
inline uint32_t uneven_limit(int32_t d_along, uint32_t uneven) noexcept {
  const auto length = static_cast<uint32_t>(d_along);
  if (!may_be_cubic(d_along)) {
    return length * (2 * uneven > length || d_along >= kMostCubic ? 90 : 190);
  }
  return length * (8 * uneven <= length   ? 640
                   : 4 * uneven <= length ? 320
                                          : 160);
}

// Whether a curve must be halved: it turns back or away from its axis, or
// strays from what is drawn by more than about 1/16 px. Slopes at the ends are
// up to 1.5, what is told by those of an even curve, (d_across -+ dd_across) /
// d_along, and by how uneven it is: e = dd_along / d_along.
inline bool must_be_halved(int32_t d_along,
                           int32_t d_across,
                           int32_t dd_along,
                           int32_t dd_across) noexcept {
  const auto uneven = static_cast<uint32_t>(abs(dd_along));
  const uint32_t bend = static_cast<uint32_t>(abs(dd_across)) + uneven;
  return bend > 16 && (2 * (static_cast<uint32_t>(abs(d_across)) + bend) >
                           3 * static_cast<uint32_t>(d_along) ||
                       bend * uneven > uneven_limit(d_along, uneven));
}

// The curve over its axis as a cubic: v0 + (s + (b + c u) u) u, u from its
// begin. Its chord is known, and half the bend in its middle; e as above.
struct Cubic {
  int32_t slope;      // s [Q16]
  int32_t half_bend;  // b
  int32_t half_jerk;  // 3 c
};

// Adds to a parabola what an uneven curve differs: its bend and its jerk are
// E (2 - e (12 x - 6)) and -12 e E, x = u / length, E = half_bend length^2. The
// slope is that which meets the other end. Returns by how much the slope there
// is less.
inline int32_t make_cubic(Cubic& cubic,
                          int32_t length,
                          int32_t dd_along,
                          const Reciprocal& over_length) noexcept {
  const int32_t e_q16 = times(dd_along, over_length);
  // Below 2^17 and 2^16: it is a pixel long and more, and e is up to 1/3.
  const int32_t more = cubic.half_bend * (3 * e_q16 >> 2) >> 14;
  cubic.half_bend += more;
  cubic.half_jerk = -(times(more >> 2, over_length) >> 5);
  const int32_t third = (cubic.half_jerk * length >> 8) * 85 >> 8;
  const int32_t less = (more + third) * length >> 8;
  cubic.slope -= less;
  return less;
}

// Rows of an edge, which of them are tips, and where it crosses the first row.
inline void set_rows(Edge& edge,
                     const Cubic& cubic,
                     uint32_t corners) noexcept {
  const int32_t to = edge.from + edge.length;
  const int32_t before = abs(edge.slope_before);
  const int32_t after = abs(edge.slope_after);
  edge.first = (edge.from >> 8) + 1;
  edge.end = (to >> 8) + 1;
  uint32_t ends = corners;
  if (abs(cubic.half_bend) > kSharp) {
    ends |= kAllTips;
  }
  const int32_t slanted = ends & kAllTips ? kSlantedIfSharp : kSlanted;
  if (before >= slanted &&
      ((edge.from + kWithinEnd) & 255) < kWithinEnd + kBeyondEnd) {
    edge.first = (edge.from + kWithinEnd) >> 8;
    ends |= kFirstTip;
  }
  if (after >= slanted && ((to + kBeyondEnd) & 255) < kWithinEnd + kBeyondEnd) {
    edge.end = ((to + kBeyondEnd) >> 8) + 1;
    ends |= kLastTip;
  }
  const int32_t u = edge.first * 256 - edge.from;
  const int32_t jerk_part = cubic.half_jerk * u >> 8;
  edge.half_jerk = cubic.half_jerk;
  edge.half_bend = cubic.half_bend + jerk_part;
  edge.ends = ends;
  edge.across =
      edge.across_before * 256 +
      ((cubic.slope + ((cubic.half_bend + (jerk_part * 85 >> 8)) * u >> 8)) *
           u >>
       8);
  // Steps go by the slope in the middle of two rows but for a third of the
  // jerk.
  edge.slope = cubic.slope + ((edge.half_bend + cubic.half_bend) * u >> 8) +
               (cubic.half_jerk * 85 >> 8);
}

// The line from points[0] to points[2], or the curve with `is_bent`; false, and
// nothing is done, if it must be halved before.
__attribute__((noinline)) bool paint_edge(const Band& band,
                                          const PixelPoint* points,
                                          bool is_bent,
                                          uint32_t corners) noexcept {
  const PixelPoint* begin = points;
  const PixelPoint* end = points + 2;
  if (!band.is_whole &&
      is_outside(band, begin->y, points[is_bent ? 1 : 2].y, end->y)) {
    return true;
  }
  int32_t d_across = end->x - begin->x;
  int32_t d_along = end->y - begin->y;
  const bool is_steep = abs(d_along) >= abs(d_across);
  if ((is_steep ? d_along : d_across) < 0) {
    begin = end;
    end = points;
    d_across = -d_across;
    d_along = -d_along;
    corners = (corners >> 1 & kCornerBefore) | (corners << 1 & kCornerAfter);
  }
  Edge edge;
  int32_t across = begin->x;
  int32_t to_across = end->x;
  edge.from = begin->y;
  if (!is_steep) {
    across = edge.from;
    to_across = end->y;
    edge.from = begin->x;
    const int32_t swapped = d_across;
    d_across = d_along;
    d_along = swapped;
  }
  edge.length = d_along;
  int32_t dd_along = 0;
  int32_t dd_across = 0;
  if (is_bent) {
    const PixelPoint& control = points[1];
    dd_along = d_along - 2 * ((is_steep ? control.y : control.x) - edge.from);
    dd_across = d_across - 2 * ((is_steep ? control.x : control.y) - across);
    if (must_be_halved(d_along, d_across, dd_along, dd_across)) {
      return false;
    }
    if (d_along < kShort) {
      corners |= kAllTips;
    }
  }
  if (__builtin_expect(static_cast<uint32_t>(d_along - 1) >= kLengthLimit - 1,
                       0)) {
    return d_along == 0;
  }
  const Reciprocal over_length = reciprocal_of(static_cast<uint32_t>(d_along));
  const int32_t chord = times(d_across, over_length);
  Cubic cubic = {chord, 0, 0};
  edge.slope_after = chord;
  // What is shorter than a 10th of a pixel or bends by no more than roundings
  // is straight, and so is what reaches slopes above 2: kSlopes ends there, and
  // products stay below 2^31.
  const int32_t bend = abs(dd_across) + abs(dd_along);
  if (bend > 10 && d_along > 24) {
    const int32_t turn =
        times(dd_across - (chord * dd_along >> 16), over_length);
    if (abs(turn) + abs(chord) <= 1 << 17) {
      cubic.half_bend = times(turn >> 2, over_length) >> 6;
      cubic.slope -= cubic.half_bend * d_along >> 8;
      edge.slope_after += turn;
      if (is_cubic(bend, d_along, dd_along)) {
        edge.slope_after -= make_cubic(cubic, d_along, dd_along, over_length);
      }
    }
  }
  edge.slope_before = cubic.slope;
  edge.across_before = across;
  edge.across_after = to_across;
  set_rows(edge, cubic, corners);
  if (is_steep) {
    paint_steep(band, edge);
  } else {
    paint_flat(band, edge);
  }
  return true;
}

// A line of any length, in parts of less than 128 px.
__attribute__((noinline)) void paint_long_line(const Band& band,
                                               const PixelPoint& from,
                                               const PixelPoint& to,
                                               uint32_t corners) noexcept {
  const int32_t dx = to.x - from.x;
  const int32_t dy = to.y - from.y;
  const int32_t length = max(abs(dx), abs(dy));
  uint32_t halvings = 0;
  while (length >> halvings >= kLengthLimit) {
    ++halvings;
  }
  PixelPoint points[3];
  points[0] = from;
  for (int32_t left = (1 << halvings) - 1; left != 0; --left) {
    points[2] = {points[0].x + (dx >> halvings),
                 points[0].y + (dy >> halvings)};
    paint_edge(band, points, false, corners & kCornerBefore);
    corners &= ~uint32_t{kCornerBefore};
    points[0] = points[2];
  }
  points[2] = to;
  paint_edge(band, points, false, corners);
}

// Of a curve's corners those of a piece; the last one has the second.
inline uint32_t ends_of(uint32_t corners,
                        const PixelPoint* piece,
                        const PixelPoint* last) noexcept {
  return piece == last ? corners : corners & kCornerBefore;
}

// A curve that must be halved: edge()[0] to edge()[2], of which the end is
// left. Its pieces share ends: at, control, middle, control, end.
__attribute__((noinline)) void paint_halves(const Band& band,
                                            OutlineCursor& cursor,
                                            uint32_t corners) noexcept {
  PixelPoint* const last = cursor.edge();
  PixelPoint* piece = last;
  uint32_t levels = 0;  // how often pieces were halved, four bits each
  bool is_painted = false;
  for (;;) {
    const uint32_t level = levels & 15;
    if (!is_painted && level != kHalvings) {
      levels = (levels + 1) << 4 | (level + 1);
      piece -= 2;
      piece[0] = piece[2];
      piece[1] = {(piece[2].x + piece[3].x) >> 1,
                  (piece[2].y + piece[3].y) >> 1};
      piece[3] = {(piece[3].x + piece[4].x) >> 1,
                  (piece[3].y + piece[4].y) >> 1};
      piece[2] = {(piece[1].x + piece[3].x + 1) >> 1,
                  (piece[1].y + piece[3].y + 1) >> 1};
    } else {
      if (!is_painted) {
        // Halved often enough: its chord.
        paint_long_line(band, piece[0], piece[2],
                        ends_of(corners, piece, last));
      }
      if (piece == last) {
        return;
      }
      corners &= ~uint32_t{kCornerBefore};
      levels >>= 4;
      piece += 2;
    }
    is_painted = paint_edge(band, piece, true, ends_of(corners, piece, last));
  }
}

inline void paint_curve(const Band& band,
                        OutlineCursor& cursor,
                        uint32_t corners) noexcept {
  if (!paint_edge(band, cursor.edge(), true, corners)) {
    paint_halves(band, cursor, corners);
  }
}

}  // namespace

void paint_distances(const Band& band,
                     OutlineCursor& cursor,
                     const ScreenPoint* points,
                     const ScreenPoint* end) noexcept {
  PixelPoint* const edge = cursor.edge();
  bool is_bent = cursor.is_bent;
  uint32_t corner = cursor.corner_at;
  const bool is_whole = band.is_whole;
  for (; points != end; ++points) {
    const int32_t x = points->x_q8 - band.x_q8;
    const int32_t y = points->y_q8() - band.y_q8;
    const uint32_t kind = points->kind();
    if (kind == kOffCurve) {
      if (is_bent) {
        edge[2] = {(edge[1].x + x) >> 1, (edge[1].y + y) >> 1};
        paint_curve(band, cursor, corner);
        edge[0] = edge[2];
        corner = 0;
      }
      edge[1] = {x, y};
      is_bent = true;
      continue;
    }
    if (kind != kStart) {
      const uint32_t corners = corner | (kind & kCornerAfter);
      static_assert(uint32_t{kCorner} == uint32_t{kCornerAfter},
                    "the kind tells whether the edge before ends at a corner");
      edge[2] = {x, y};
      if (is_bent) {
        paint_curve(band, cursor, corners);
      } else if (edge[0].x == x) {
        paint_vertical(band, x, edge[0].y, y);
      } else if (edge[0].y == y) {
        paint_horizontal(band, y, edge[0].x, x);
      } else if (!paint_edge(band, edge, false, corners)) {
        paint_long_line(band, edge[0], edge[2], corners);
      }
      if (kind == kCorner) {
        paint_vertex(band, x, y);
      }
    }
    corner = kind >> 1;
    edge[0] = {x, y};
    is_bent = false;
    if (!is_whole && is_outside(band, y)) {
      points = skip_outside(band, points, end);
      edge[0] = {points->x_q8 - band.x_q8, points->y_q8() - band.y_q8};
      corner = points->kind() >> 1;
    }
  }
  cursor.is_bent = is_bent;
  cursor.corner_at = corner;
}

}  // namespace detail
}  // namespace inkcell
