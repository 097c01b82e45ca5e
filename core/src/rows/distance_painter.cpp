// Distances to an outline, only where the ramp of the filter is (Perry and
// Frisken, section 3.3.2, in bands of rows).
//
// A pixel's byte holds the nearness to the edge in bits 1 to 7, 254 on the edge
// and 0 from half a pixel on, and in bit 0 whether a contour passes between it
// and the pixel to its left: an odd number of such bits up to a pixel means
// that it is inside. Nearness only grows and bits only change, so that neither
// the order of edges nor the cut into bands matters.
//
// An edge paints the pixels whose feet lie on it (edge_rows.cpp). Where two
// edges meet, at a corner or within a curve, the pixel nearest to that point is
// painted as well; no other pixel is within half a pixel of it. So none is left
// out between two edges, however much the contour turns.
#include "rows/band.hpp"

#include "base/math.hpp"
#include "rows/contours.hpp"
#include "rows/reciprocal.hpp"

namespace inkcell::detail {
namespace {

// The pixel nearest to a vertex: no other one lies within half a pixel.
__attribute__((noinline)) void paint_vertex(const Band& band,
                                            int32_t x,
                                            int32_t y) noexcept {
  x += 128;
  y += 128;
  const int32_t row = y >> 8;
  const int32_t column = x >> 8;
  if (!is_below(row, band.rows) || !is_up_to(column, band.last_column)) {
    return;
  }
  int32_t longer = abs((x & 255) - 128);
  int32_t shorter = abs((y & 255) - 128);
  if (longer < shorter) {
    swap(longer, shorter);
  }
  uint8_t* const pixel = band.row(row) + column;
  const int32_t old = *pixel;
  int32_t nearness = 254 - 2 * longer;
  if (old < nearness) {
    // The length of a vector, doubled: max(2 a, 7/4 a + b), within 3 %.
    nearness -= max(shorter - (longer >> 2), 0) & ~1;
    if (old < nearness) {
      *pixel = static_cast<uint8_t>(nearness | (old & 1));
    }
  }
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
  if (count <= 0 || !is_up_to(row + 1, band.rows)) {
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

// A line of any length.
__attribute__((noinline)) void paint_long_line(const Band& band,
                                               const PixelPoint& from,
                                               const PixelPoint& to) noexcept {
  PixelPoint points[3] = {from};
  cut_line(from, to, kLengthLimit, [&](PixelPoint, PixelPoint end) noexcept {
    points[2] = end;
    paint_edge(band, points, false);
    points[0] = end;
  });
}

// A curve that must be halved: edge()[0] to edge()[2], of which the end is
// left. Its pieces share ends: at, control, middle, control, end.
__attribute__((noinline)) void paint_halves(const Band& band,
                                            OutlineCursor& cursor) noexcept {
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
      paint_vertex(band, piece[2].x, piece[2].y);
    } else {
      if (!is_painted) {
        // Halved often enough: its chord.
        paint_long_line(band, piece[0], piece[2]);
      }
      if (piece == last) {
        return;
      }
      levels >>= 4;
      piece += 2;
    }
    is_painted = paint_edge(band, piece, true);
  }
}

struct DistancePainter {
  static constexpr bool kNearRows = true;
  const Band& band;
  OutlineCursor& cursor;

  void start(const PixelPoint&) const noexcept {}
  void take(PixelPoint* edge, bool is_bent, uint32_t) const noexcept {
    const int32_t x = edge[2].x;
    const int32_t y = edge[2].y;
    if (is_bent) {
      if (!paint_edge(band, edge, true)) {
        paint_halves(band, cursor);
      }
    } else if (edge[0].x == x) {
      paint_vertical(band, x, edge[0].y, y);
    } else if (edge[0].y == y) {
      paint_horizontal(band, y, edge[0].x, x);
    } else if (!paint_edge(band, edge, false)) {
      paint_long_line(band, edge[0], edge[2]);
    }
    paint_vertex(band, x, y);
  }
};

}  // namespace

void paint_distances(const Band& band,
                     OutlineCursor& cursor,
                     const ScreenPoint* points,
                     const ScreenPoint* end) noexcept {
  DistancePainter painter = {band, cursor};
  walk_contours(band, cursor.edge(), cursor.is_bent, points, end, painter);
}

}  // namespace inkcell::detail
