// Paints exact areas under outlines, for any width of pixels.
//
// A pixel holds what coverage gains from the pixel to its left to it,
// modulo 256, where a full pixel is 240: sums along a row are exact however
// large the differences are, and 16 values are left for roundings on both
// sides. An edge that goes down gains, one that goes up loses:
//
//     in one column           in several: at a column the sum is what lies to
//     +-------+-------+       the left of the edge in the column's middle
//     |    /  |       |       +-------+-------+-------+
//     |  /####|#######|       |       |    _-#|#######|
//     |/######|#######|       |   _-##|#######|#######|
//     +-------+-------+       +-------+-------+-------+
//      d - t      t            t = d (mean distance to the column's left)
//
// Every height becomes units once (units_of), so that a row's sum is the
// winding number, whatever was rounded.
//
// Over 400 lines: one painter, whose loops are inlined into each other.
#pragma once

#include "base/math.hpp"
#include "rows/band.hpp"
#include "rows/contours.hpp"
#include "rows/reciprocal.hpp"

namespace inkcell::detail {

// `Rows`: the type of pixels, with room for kFull. A type without linkage, so
// that a painter's functions are inlined into each other.
template <typename Rows>
class AreaPainter {
 public:
  static void paint(const Band& band,
                    OutlineCursor& cursor,
                    const ScreenPoint* points,
                    const ScreenPoint* end) noexcept {
    Visitor visitor = {band};
    walk_contours(band, cursor.first_edge(), cursor.is_bent, points, end,
                  visitor);
  }

 private:
  using Pixel = typename Rows::Pixel;

  static Pixel* row_of(const Band& band, int32_t i) noexcept {
    return reinterpret_cast<Pixel*>(band.bytes) + i * band.stride;
  }

  static constexpr int32_t kFull = 240;

  // Chords stray no farther from a curve. [px, Q8]
  static constexpr int32_t kTolerance = 6;

  // At most 2^6 chords a curve.
  static constexpr uint32_t kMostHalvings = 6;

  // Curves with longer legs, 4096 px, are drawn as a line: products stay below
  // 2^31.
  static constexpr uint32_t kLegLimit = 1 << 20;

  // So are curves farther away, 8192 px.
  static constexpr uint32_t kFarLimit = 1 << 21;

  // A height in units. [px, Q8 -> 1/240]
  static int32_t units_of(int32_t y_q8) noexcept {
    return y_q8 - ((y_q8 + 8) >> 4);
  }

  static void add(Pixel* pixel, int32_t gain) noexcept {
    *pixel = static_cast<Pixel>(*pixel + static_cast<uint32_t>(gain));
  }

  // A row's part of an edge that passes several columns, from `left` to
  // `right`. `rise`: what the edge gains in a 256th of a column. [Q16]
#if !defined(__OPTIMIZE_SIZE__)
  __attribute__((noinline))
#endif
  static void
  add_wide(const Band& band,
           Pixel* row,
           int32_t left,
           int32_t right,
           int32_t gain,
           int32_t rise) noexcept {
    const int32_t last = (right - 1) >> 8;
    int32_t column = left >> 8;
    const int32_t in_first = 256 - (left & 255);
    int32_t before = ((in_first * rise >> 8) * in_first + 65536) >> 17;
    int32_t sum = rise * in_first + rise * 128 + 32768;
    const int32_t limit = band.last_column + 1;
    if (column >= 0) {
      if (column > limit) {
        return;
      }
      add(row + column, before);
    } else {
      before = 0;
    }
    // `before`: what columns to the left show of the sum.
    while (++column != last) {
      const int32_t at = sum >> 16;
      if (is_up_to(column, limit)) {
        add(row + column, at - before);
        before = at;
      }
      sum += rise * 256;
    }
    const int32_t in_last = ((right - 1) & 255) + 1;
    const int32_t at = gain - (((in_last * rise >> 8) * in_last + 65536) >> 17);
    if (is_up_to(last, limit)) {
      add(row + last, at - before);
      before = at;
    }
    if (last < limit) {
      add(row + max(last + 1, 0), gain - before);
    }
  }

  // The same within two columns, both of the band and not its last; `in_first`
  // and `in_last`: how much of each it passes.
  static void add_two(Pixel* pixel,
                      int32_t in_first,
                      int32_t in_last,
                      int32_t gain,
                      int32_t rise) noexcept {
    const int32_t before = ((in_first * rise >> 8) * in_first + 65536) >> 17;
    const int32_t at = gain - (((in_last * rise >> 8) * in_last + 65536) >> 17);
    add(pixel, before);
    add(pixel + 1, at - before);
    add(pixel + 2, gain - at);
  }

  // Within several columns, most often two.
  static void add_columns(const Band& band,
                          Pixel* row,
                          int32_t left,
                          int32_t right,
                          int32_t gain,
                          int32_t rise) noexcept {
    const int32_t column = left >> 8;
    const int32_t in_last = right - 256 * column - 256;
    if (!kIsSmall && in_last <= 256 && is_below(column, band.last_column)) {
      add_two(row + column, 256 - (left & 255), in_last, gain, rise);
    } else {
      add_wide(band, row, left, right, gain, rise);
    }
  }

  // Within one column. `twice`: the sum of both ends' distances to its left.
  static void add_narrow(int32_t last_column,
                         Pixel* row,
                         int32_t column,
                         int32_t twice,
                         int32_t gain) noexcept {
    if (is_up_to(column, last_column)) {
      const int32_t behind = (twice * gain + 256) >> 9;
      add(row + column, gain - behind);
      add(row + column + 1, behind);
    } else if (column < 0) {
      add(row, gain);
    }
  }

  __attribute__((noinline)) static void add_any(const Band& band,
                                                Pixel* row,
                                                int32_t from,
                                                int32_t to,
                                                int32_t gain) noexcept {
    const int32_t left = min(from, to);
    const int32_t right = max(from, to);
    const int32_t column = left >> 8;
    if (right - column * 256 <= 256) {
      add_narrow(band.last_column, row, column, left + right - 512 * column,
                 gain);
    } else {
      add_columns(
          band, row, left, right, gain,
          times(gain, reciprocal_of(static_cast<uint32_t>(right - left))));
    }
  }

  static void add_part(const Band& band,
                       Pixel* row,
                       int32_t from,
                       int32_t to,
                       int32_t gain) noexcept {
    if (!kIsSmall && __builtin_expect((from ^ to) >> 8 == 0, 1)) {
      add_narrow(band.last_column, row, from >> 8, (from & 255) + (to & 255),
                 gain);
    } else {
      add_any(band, row, from, to, gain);
    }
  }

  // Rows that a vertical edge passes as a whole; it lies at `x`, or to the left
  // of the band.
  static void paint_whole_rows(Pixel* row,
                               int32_t stride,
                               int32_t count,
                               int32_t x,
                               int32_t full) noexcept {
    if (x < 0) {
      do {
        add(row, full);
        row += stride;
      } while (--count != 0);
      return;
    }
    const int32_t behind = ((x & 255) * full + 128) >> 8;
    row += x >> 8;
    do {
      add(row, full - behind);
      add(row + 1, behind);
      row += stride;
    } while (--count != 0);
  }

  __attribute__((noinline)) static void paint_upright(const Band& band,
                                                      int32_t x,
                                                      int32_t from,
                                                      int32_t to) noexcept {
    const int32_t full = (from < to) != band.is_mirrored ? kFull : -kFull;
    const int32_t top = max(min(from, to), 0);
    const int32_t bottom = min(max(from, to), band.rows * 256);
    const int32_t column = x >> 8;
    if (top >= bottom || column > band.last_column) {
      return;
    }
    const int32_t stride = band.stride;
    Pixel* bytes = row_of(band, top >> 8);
    for (int32_t y = top; y != bottom;) {
      int32_t next = min((y | 255) + 1, bottom);
      if (next - y != 256) {
        const int32_t units = units_of(next) - units_of(y);
        add_narrow(band.last_column, bytes, column, (x & 255) * 2,
                   full < 0 ? -units : units);
        bytes += stride;
      } else {
        next = bottom & ~255;
        paint_whole_rows(bytes, stride, (next - y) >> 8, x, full);
        bytes += ((next - y) >> 8) * stride;
      }
      y = next;
    }
  }

// `count` rows that a line passes from top to bottom. [px, Q16]
#if !defined(__OPTIMIZE_SIZE__)
  __attribute__((noinline))
#endif
  static void
  paint_full_rows(const Band& band,
                  Pixel* row,
                  int32_t count,
                  int32_t x_q16,
                  int32_t slope,
                  int32_t full) noexcept {
    int32_t rise = 0;
    const int32_t width = abs(slope) >> 8;
    x_q16 += min(slope, 0);  // the left end of a row's part
    const int32_t last_column = band.last_column;
    const int32_t stride = band.stride;
    do {
      const int32_t left = x_q16 >> 8;
      if (kIsSmall) {
        add_any(band, row, left, left + width, full);
      } else if (__builtin_expect((left & 255) + width <= 256, 1)) {
        add_narrow(last_column, row, x_q16 >> 16, (left & 255) * 2 + width,
                   full);
      } else {
        if (rise == 0) {
          rise = times(full, reciprocal_of(static_cast<uint32_t>(width)));
        }
        add_columns(band, row, left, left + width, full, rise);
      }
      x_q16 += slope;
      row += stride;
    } while (--count != 0);
  }

  // A line in several rows, vertical or shorter than kLengthLimit in both
  // directions.
  __attribute__((noinline)) static void paint_rows(const Band& band,
                                                   int32_t x0,
                                                   int32_t y0,
                                                   int32_t x1,
                                                   int32_t y1) noexcept {
    bool gains = !band.is_mirrored;
    if (y0 > y1) {
      gains = !gains;
      swap(x0, x1);
      swap(y0, y1);
    }
    const int32_t high = band.rows * 256;
    int32_t slope = 0;
    if (!kIsSmall || x0 != x1) {
      slope = times(x1 - x0, reciprocal_of(static_cast<uint32_t>(y1 - y0)));
    }
    int32_t x_q16 = x0 * 256;
    if (y0 < 0) {
      x_q16 += (-y0 >> 8) * slope + ((-y0 & 255) * slope >> 8);
      y0 = 0;
    }
    int32_t row = y0 >> 8;
    Pixel* bytes = row_of(band, row);
    if ((y0 & 255) != 0) {
      const int32_t next_q16 = x_q16 + ((256 - (y0 & 255)) * slope >> 8);
      const int32_t units = kFull - units_of(y0 & 255);
      add_part(band, bytes, x_q16 >> 8, next_q16 >> 8, gains ? units : -units);
      x_q16 = next_q16;
      bytes += band.stride;
      ++row;
    }
    const int32_t end = min(y1, high);
    const int32_t count = (end >> 8) - row;
    if (count > 0) {
      paint_full_rows(band, bytes, count, x_q16, slope, gains ? kFull : -kFull);
      x_q16 += slope * count;
      bytes += band.stride * count;
    }
    if ((end & 255) != 0) {
      const int32_t units = units_of(end & 255);
      add_part(band, bytes, x_q16 >> 8, x1, gains ? units : -units);
    }
  }

  // The same in any number of rows; most lines lie in one.
  static void paint_short_line(const Band& band,
                               int32_t x0,
                               int32_t y0,
                               int32_t x1,
                               int32_t y1) noexcept {
    if ((y0 ^ y1) >> 8 != 0) {
      // Not all of it above or below.
      const int32_t last = band.rows * 256 - 1;
      if (((y0 & y1) | ((last - y0) & (last - y1))) >= 0) {
        paint_rows(band, x0, y0, x1, y1);
      }
      return;
    }
    const int32_t row = y0 >> 8;
    const int32_t units = units_of(y1 & 255) - units_of(y0 & 255);
    if (is_below(row, band.rows)) {
      add_part(band, row_of(band, row), x0, x1,
               band.is_mirrored ? -units : units);
    }
  }

  __attribute__((noinline)) static void paint_line(
      const Band& band, const PixelPoint& from, const PixelPoint& to) noexcept {
    cut_line(from, to, kLengthLimit,
             [&band](PixelPoint a, PixelPoint b) noexcept {
               paint_short_line(band, a.x, a.y, b.x, b.y);
             });
  }

  // All magnitudes are below a power of 2 if this is, or equal it.
  static uint32_t magnitudes(int32_t a,
                             int32_t b,
                             int32_t c,
                             int32_t d) noexcept {
    const auto bits = [](int32_t value) noexcept {
      return static_cast<uint32_t>(value ^ value >> 31);
    };
    return bits(a) | bits(b) | bits(c) | bits(d);
  }

  // 2^n chords. Their joints lie outside of the curve by two thirds of how far
  // chords would stray: then they hold as much area as the curve. So does the
  // end of a smooth one, which is moved.
  __attribute__((noinline)) static void paint_curve(const Band& band,
                                                    PixelPoint* edge,
                                                    bool is_smooth) noexcept {
    const PixelPoint at = edge[0];
    const PixelPoint control = edge[1];
    const PixelPoint to = edge[2];
    const bool is_seen =
        band.is_whole || !is_outside(band, at.y, control.y, to.y);
    if (!is_seen && !is_smooth) {
      return;
    }
    const int32_t ax = control.x - at.x;
    const int32_t ay = control.y - at.y;
    const int32_t bx = to.x - control.x;
    const int32_t by = to.y - control.y;
    const uint32_t legs = magnitudes(ax, ay, bx, by);
    if (legs >= kLegLimit || magnitudes(at.x, at.y, to.x, to.y) >= kFarLimit) {
      paint_line(band, at, to);
      return;
    }
    const int32_t ddx = bx - ax;
    const int32_t ddy = by - ay;
    int32_t strays = rough_length(ddx, ddy);
    uint32_t halvings = 0;
    for (; strays > 4 * kTolerance && halvings != kMostHalvings; strays >>= 2) {
      ++halvings;
    }
    // Second differences of chords. [px, Q17]
    const int32_t d2x = ddx * 512 >> 2 * halvings;
    const int32_t d2y = ddy * 512 >> 2 * halvings;
    const PixelPoint out = {-(d2x * 11 >> 15), -(d2y * 11 >> 15)};
    if (is_smooth) {
      edge[2].x += out.x;
      edge[2].y += out.y;
    }
    if (is_seen) {
      // Chords are at most twice as long as legs.
      const bool are_short = legs < kLengthLimit / 4;
      int32_t dx = (ax * 1024 >> halvings) + d2x;
      int32_t dy = (ay * 1024 >> halvings) + d2y;
      int32_t x = (at.x + out.x) * 512 + 256;
      int32_t y = (at.y + out.y) * 512 + 256;
      int32_t from_x = at.x;
      int32_t from_y = at.y;
      for (uint32_t left = 1u << halvings; left != 0;) {
        int32_t to_x = edge[2].x;
        int32_t to_y = edge[2].y;
        if (--left != 0) {
          x += dx;
          y += dy;
          dx += 2 * d2x;
          dy += 2 * d2y;
          to_x = x >> 9;
          to_y = y >> 9;
        }
        if (are_short) {
          paint_short_line(band, from_x, from_y, to_x, to_y);
        } else {
          paint_line(band, {from_x, from_y}, {to_x, to_y});
        }
        from_x = to_x;
        from_y = to_y;
      }
    }
  }

  struct Visitor {
    static constexpr bool kNearRows = true;
    const Band& band;

    void start(const PixelPoint&) const noexcept {}
    void take(PixelPoint* edge, bool is_bent, uint32_t kind) const noexcept {
      if (is_bent) {
        paint_curve(band, edge, kind == kOffCurve);
      } else if (edge[0].x == edge[2].x) {
        if (kIsSmall) {
          paint_short_line(band, edge[2].x, edge[0].y, edge[2].x, edge[2].y);
        } else {
          paint_upright(band, edge[2].x, edge[0].y, edge[2].y);
        }
      } else if (edge[0].y != edge[2].y) {
        paint_line(band, edge[0], edge[2]);
      }
    }
  };
};

}  // namespace inkcell::detail
