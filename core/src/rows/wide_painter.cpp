// Outlines to rows of distances, up to 4 px from the edge: lines and curves of
// a glyph's contours as chords (wide_chord.hpp).
#include "rows/band.hpp"

#include "base/math.hpp"
#include "rows/contours.hpp"
#include "rows/reciprocal.hpp"
#include "rows/wide_chord.hpp"

namespace inkcell::detail {
namespace wide {
namespace {

// Chords stray no farther from a curve. [px, Q8]
constexpr int32_t kTolerance = 12;

constexpr int32_t kMostChords = 32;

// Curves with longer legs, 1024 px, are drawn as a line: products stay below
// 2^31.
constexpr int32_t kLegLimit = 1 << 18;

template <typename Marks>
__attribute__((noinline)) void paint_line(const Band& band,
                                          const PixelPoint& from,
                                          const PixelPoint& to,
                                          uint32_t corners) noexcept {
  const Tangent along = tangent_of(to.x - from.x, to.y - from.y);
  paint_chord<Marks>(band, from, to,
                     (corners & 1) != 0 ? along : joined(band, along),
                     (corners & 2) != 0 ? along : joined(band, along));
}

// How many chords a curve of second difference `bend` takes. One strays from it
// by bend / 4; of more the joints are moved outwards by half of that, which
// leaves 3 / 16 where a chord ends at a stored point.
inline int32_t chords_of(int32_t bend, int32_t leg) noexcept {
  int32_t count = 1;
  if (bend > 4 * kTolerance) {
    do {
      ++count;
    } while (count != kMostChords &&
             count * count * 16 * kTolerance < 3 * bend);
  }
  // Chords that are not tiny turn by less than 28 degrees.
  if (bend > 64) {
    while (count != kMostChords && count * leg < 2 * bend) {
      ++count;
    }
  }
  return count;
}

// `corners`: bit 0, 1: the curve begins, ends at a corner.
template <typename Marks>
__attribute__((noinline)) void paint_curve(const Band& band,
                                           const PixelPoint& from,
                                           const PixelPoint& control,
                                           const PixelPoint& to,
                                           uint32_t corners) noexcept {
  const int32_t ax = control.x - from.x;
  const int32_t ay = control.y - from.y;
  const int32_t bx = to.x - control.x;
  const int32_t by = to.y - control.y;
  const int32_t a = rough_length(ax, ay);
  const int32_t b = rough_length(bx, by);
  if (max(a, b) >= kLegLimit || a == 0 || b == 0) {
    paint_line<Marks>(band, from, to, corners);
    return;
  }
  const Tangent first = tangent_of(ax, ay);
  const Tangent last = tangent_of(bx, by);
  Tangent before = (corners & 1) != 0 ? first : joined(band, first);
  const Tangent end = (corners & 2) != 0 ? last : joined(band, last);
  const int32_t bend_x = bx - ax;
  const int32_t bend_y = by - ay;
  const int32_t count = chords_of(rough_length(bend_x, bend_y), min(a, b));
  PixelPoint at = from;
  if (count != 1) {
    // from + 2 t a + t t (b - a), and what joints are moved by.
    const int32_t step_q10 =
        times(1, reciprocal_of(static_cast<uint32_t>(count))) >> 6;
    const int32_t move_x = (bend_x * step_q10 >> 10) * step_q10 >> 13;
    const int32_t move_y = (bend_y * step_q10 >> 10) * step_q10 >> 13;
    for (int32_t t_q10 = step_q10, i = 1; i != count; t_q10 += step_q10, ++i) {
      const int32_t along_x = bend_x * t_q10 >> 10;
      const int32_t along_y = bend_y * t_q10 >> 10;
      const PixelPoint next = {
          from.x + ((2 * ax + along_x) * t_q10 >> 10) - move_x,
          from.y + ((2 * ay + along_y) * t_q10 >> 10) - move_y};
      const Tangent after = tangent_of(ax + along_x, ay + along_y);
      paint_chord<Marks>(band, at, next, before, after);
      before = after;
      at = next;
    }
  }
  paint_chord<Marks>(band, at, to, before, end);
}

inline PixelPoint difference(const PixelPoint& a,
                             const PixelPoint& b) noexcept {
  return {a.x - b.x, a.y - b.y};
}
inline bool is_zero(const PixelPoint& a) noexcept {
  return (a.x | a.y) == 0;
}

// Whether a piece between these heights may show something.
bool is_within_reach(const Band& band,
                     int32_t y0,
                     int32_t y1,
                     int32_t y2) noexcept {
  return !is_outside(band, y0, y1, y2, band.reach_q8, band.reach_q8);
}

template <typename Marks>
struct WidePainter {
  static constexpr bool kNearRows = false;
  const Band& band;
  OutlineCursor& at;

  void start(const PixelPoint& point) const noexcept {
    at.start() = point;
    at.before() = {0, 0};
    at.corner_at = 1;
  }

  void take(PixelPoint* edge, bool is_bent, uint32_t kind) const noexcept {
    const uint32_t corner = kind >> 1;  // 1 if it ends at one
    const PixelPoint next = edge[2];
    PixelPoint after = difference(is_bent ? edge[1] : next, edge[0]);
    if (is_zero(after)) {
      after = difference(next, edge[0]);
    }
    if (at.corner_at != 0) {
      if (is_zero(at.before())) {
        at.first() = after;
      } else {
        paint_corner<Marks>(band, edge[0], at.before(), after);
      }
    }
    const uint32_t corners = at.corner_at | corner << 1;
    if (!is_bent) {
      if (is_within_reach(band, edge[0].y, next.y, next.y)) {
        paint_line<Marks>(band, edge[0], next, corners);
      }
    } else if (is_within_reach(band, edge[0].y, edge[1].y, next.y)) {
      paint_curve<Marks>(band, edge[0], edge[1], next, corners);
    }
    PixelPoint before = difference(next, is_bent ? edge[1] : edge[0]);
    if (is_zero(before)) {
      before = difference(next, edge[0]);
    }
    if (!is_zero(before)) {
      at.before() = before;
    }
    at.corner_at = static_cast<uint8_t>(corner);
    if (kind == kCorner && is_zero(difference(next, at.start()))) {
      paint_corner<Marks>(band, next, at.before(), at.first());
    }
  }
};

template <typename Marks>
void paint_points(const Band& band,
                  OutlineCursor& cursor,
                  const ScreenPoint* points,
                  const ScreenPoint* end) noexcept {
  WidePainter<Marks> painter = {band, cursor};
  walk_contours(band, cursor.edge(), cursor.is_bent, points, end, painter);
}

// The lowest bit toggles from outside to inside and back.
struct Toggles {
  static constexpr int32_t kMask = ~1;
  static constexpr bool kHasColumns = false;
  static void cross_row(uint8_t* pixel) noexcept { *pixel ^= 1; }
  static void cross_column(uint8_t*) noexcept {}
};

struct Crossings {
  static constexpr int32_t kMask = ~7;
  static constexpr bool kHasColumns = true;
  static void cross_row(uint8_t* pixel) noexcept {
    *pixel = static_cast<uint8_t>((*pixel ^ kInsideBit) | kCrossedLeft);
  }
  static void cross_column(uint8_t* pixel) noexcept { *pixel |= kCrossedAbove; }
};

}  // namespace
}  // namespace wide

void paint_wide_distances(const Band& band,
                          OutlineCursor& cursor,
                          const ScreenPoint* points,
                          const ScreenPoint* end) noexcept {
  wide::paint_points<wide::Toggles>(band, cursor, points, end);
}

void paint_crossings(const Band& band,
                     OutlineCursor& cursor,
                     const ScreenPoint* points,
                     const ScreenPoint* end) noexcept {
  wide::paint_points<wide::Crossings>(band, cursor, points, end);
}

}  // namespace inkcell::detail
