// Pixels beside an edge, row by row if it is steep, else column by column. What
// is a row here is a column of a flat edge.
//
// Where an edge crosses a row, with a slope of at most 1.73, all pixels within
// half a pixel of it are the two beside the crossing:
//
//        f     1 - f             distances: f cos a and (1 - f) cos a,
//      o-----x-------o           a = the angle between the edge and the axis
//           /
//
// A curve is a parabola over its axis: one reciprocal, three additions a row.
// Only near the ends of an edge the foot of a pixel may lie beyond it, or its
// row, but not its foot. Such rows are tips: their pixels are painted if their
// feet lie on the edge. Of those beyond, the end is the nearest point.
//
// Over 400 lines: one painter, whose loops are inlined into each other.
#include "rows/band.hpp"

#include "base/math.hpp"
#include "rows/reciprocal.hpp"

namespace inkcell::detail {
namespace {

// A tip is a row at most kBeyondEnd beyond an end that is steeper than
// kSlanted, or at most kWithinEnd before it. Of a flatter one the foot of a
// pixel within half a pixel lies so near to its row that its distance changes
// by less than 0.04 px. [px, Q8; Q16]
constexpr int32_t kBeyondEnd = 72;
constexpr int32_t kWithinEnd = 48;
constexpr int32_t kSlanted = 13 << 11;

// Feet so far beyond an end still lie on the edge. [px, Q8]
constexpr int32_t kSlack = 8;

// All rows of a parabola with a radius of 1.6 px or less are tips, as the
// nearest point lies where it has left its tangent. Slopes at its ends are
// rough: 1/4 counts as slanted. [Q16]
constexpr int32_t kSharp = 5 << 12;  // of half the bend
constexpr int32_t kSlantedIfSharp = 1 << 14;

// By slope in 1/32, from -2 to 2 and what roundings add.
struct Slopes {
  static constexpr int32_t kMost = 66;
  uint8_t cosines[2 * kMost + 1] = {};   // 254 cos a
  uint8_t sine_cosines[kMost + 1] = {};  // 256 sin a cos a, by magnitude

  constexpr Slopes() noexcept {
    for (int32_t i = 0; i <= kMost; ++i) {
      const int32_t square = 32 * 32 + i * i;  // of the length, in 32nds
      int32_t cosine = 254;
      while ((2 * cosine - 1) * (2 * cosine - 1) * square >
             4 * (254 * 32) * (254 * 32)) {
        --cosine;
      }
      cosines[kMost - i] = cosines[kMost + i] = static_cast<uint8_t>(cosine);
      sine_cosines[i] =
          static_cast<uint8_t>((256 * 32 * i + square / 2) / square);
    }
  }
};
constexpr Slopes kSlopes;

// A slope in 1/32, to the nearest.
inline int32_t in_32nds(int32_t slope_q16) noexcept {
  return (slope_q16 + (1 << 10)) >> 11;
}

// A parabola through an end of an edge, that at `along`. [px, Q8; Q16]
struct Tip {
  int32_t along;
  int32_t across;
  int32_t slope;
  int32_t half_bend;  // what the slope gains in half a row
  int32_t from;       // what of the axis the edge covers
  int32_t to;
  bool is_steep;
};

// How far a parabola leaves its tangent on the way to a foot. [1/508 px]
inline int32_t sag_of(int32_t half_bend, int32_t foot, int32_t fall) noexcept {
  return ((half_bend >> 7) * (foot * foot) >> 10) * fall >> 15;
}

// The pixels beside a crossing, `pixel` and the one `stride` after it, if their
// feet lie on the edge. `before` and `after`: how far the row lies from the
// ends of the edge; `away`: from where the tangent touches. [px, Q8]
inline void paint_tip_pair(uint8_t* pixel,
                           int32_t stride,
                           int32_t half_bend,
                           uint32_t fraction,
                           int32_t slope_q16,
                           int32_t before,
                           int32_t after,
                           int32_t away) noexcept {
  const int32_t slope = min(abs(in_32nds(slope_q16)), Slopes::kMost);
  const int32_t fall = kSlopes.cosines[Slopes::kMost + slope] * 2;
  const int32_t sine_cosine = kSlopes.sine_cosines[slope];
  const int32_t along = slope_q16 < 0 ? -sine_cosine : sine_cosine;
  // From the row to the foot.
  int32_t foot = -(static_cast<int32_t>(fraction) * along >> 16);
  int32_t distance =
      static_cast<int32_t>(fraction * static_cast<uint32_t>(fall) >> 16);
  for (int32_t side = 0; side < 2; ++side) {
    if (before + foot >= -kSlack && after - foot >= -kSlack) {
      int32_t sag = 0;
      if (half_bend != 0) {
        sag = sag_of(half_bend, foot + away, fall);
      }
      const int32_t nearest =
          max(side == 0 ? distance + sag : distance - sag, 0);
      approach(pixel, 254 - (nearest & ~1));
    }
    pixel += stride;
    foot += along;
    distance = fall - distance;
  }
}

// Bits of the rows between two crossings of columns.
void toggle_rows(const Band& band,
                 int32_t column,
                 int32_t from,
                 int32_t to) noexcept {
  if (column > band.last_column + 1) {
    return;
  }
  column = max(column, 0);
  int32_t first = max(min(from, to) + 1, 0);
  const int32_t end = min(max(from, to) + 1, band.rows);
  for (; first < end; ++first) {
    band.row(first)[column] ^= 1;
  }
}

// A row near an end. `above`: of a flat edge the row above it so far; returns
// that of the next column.
__attribute__((noinline)) int32_t paint_tip(const Band& band,
                                            const Tip& tip,
                                            int32_t row,
                                            int32_t above) noexcept {
  const int32_t before = row * 256 - tip.from;
  const int32_t after = tip.to - row * 256;
  const int32_t u = row * 256 - tip.along;
  int32_t bent = 0;
  int32_t away = u;  // beyond its ends an edge goes on straight
  if ((before | after) >= 0) {
    bent = tip.half_bend * u >> 8;
    away = 0;
  }
  const int32_t across = tip.across * 256 + ((tip.slope + bent) * u >> 8);
  const int32_t slope = tip.slope + 2 * bent;
  const int32_t column = across >> 16;
  const auto fraction = static_cast<uint32_t>(across) & 0xffff;
  const bool is_crossed = before > 0 && after >= 0;
  uint8_t* pixel;
  int32_t stride = 1;
  if (tip.is_steep) {
    if (!is_below(row, band.rows) || column > band.last_column) {
      return above;
    }
    pixel = band.row(row) + max(column, -1);
    pixel[1] ^= is_crossed ? 1 : 0;
    if (column < 0) {
      return above;
    }
  } else {
    if (is_crossed && column != above) {
      toggle_rows(band, row, above, column);
      above = column;
    }
    if (!is_up_to(column + 1, band.rows) || !is_up_to(row, band.last_column)) {
      return above;
    }
    stride = band.stride;
    pixel = band.row(column) + row;
  }
  paint_tip_pair(pixel, stride, tip.half_bend, fraction, slope, before, after,
                 away);
  return above;
}

// All rows of a sharp bend. `tip`: at the first end; `last`: the other one.
__attribute__((noinline)) void paint_sharp(const Band& band,
                                           Tip& tip,
                                           int32_t last_across,
                                           int32_t last_slope) noexcept {
  int32_t row = (tip.from >> 8) + 1;
  if (abs(tip.slope) >= kSlantedIfSharp) {
    row = (tip.from + kWithinEnd) >> 8;
  }
  int32_t stop = tip.to >> 8;
  if (abs(last_slope) >= kSlantedIfSharp) {
    stop = (tip.to + kBeyondEnd) >> 8;
  }
  int32_t above = tip.across >> 8;
  for (; row <= stop; ++row) {
    if (row * 256 > tip.to) {
      tip.along = tip.to;
      tip.across = last_across;
      tip.slope = last_slope;
    }
    above = paint_tip(band, tip, row, above);
  }
  if (!tip.is_steep && last_across >> 8 != above) {
    toggle_rows(band, (tip.to >> 8) + 1, above, last_across >> 8);
  }
}

// The pixels on both sides of a crossing lie at f and 1 - f of a pixel from it,
// so that they are f cos a and (1 - f) cos a away from the edge. `nearness` is
// that of the first, the result that of the second: their distances add up to
// 508 cos a, what nearness falls by in a pixel.
inline int32_t nearness_pair(int32_t across,
                             int32_t slope,
                             int32_t& nearness) noexcept {
  const uint32_t cosine = (kSlopes.cosines + Slopes::kMost)[in_32nds(slope)];
  const auto distance = static_cast<int32_t>(
      ((static_cast<uint32_t>(across) & 0xffff) * cosine >> 15) & ~1u);
  nearness = 254 - distance;
  return 254 + distance - 2 * static_cast<int32_t>(cosine);
}

// Rows without tests, all in the band: from where the edge crosses the first
// one. [Q16]
inline void paint_rows(const Band& band,
                       int32_t row,
                       int32_t end,
                       int32_t across,
                       int32_t slope,
                       int32_t half_bend) noexcept {
  const int32_t last_column = band.last_column;
  const int32_t stride = band.stride;
  uint8_t* bytes = band.row(row);
  int32_t count = end - row;
  do {
    const int32_t column = across >> 16;
    if (__builtin_expect(is_up_to(column, last_column), 1)) {
      uint8_t* const pixel = bytes + column;
      int32_t nearness;
      const int32_t other = nearness_pair(across, slope, nearness);
      approach(pixel, nearness);
      int32_t old = pixel[1];
      if (old < other) {
        old = other | (old & 1);
      }
      pixel[1] = static_cast<uint8_t>(old ^ 1);
    } else if (column < 0) {
      bytes[0] ^= 1;
    }
    slope += half_bend;
    across += slope;
    slope += half_bend;
    bytes += stride;
  } while (--count != 0);
}

// The row of a flat edge in a column; null if the band has no part of the pair.
inline uint8_t* pair_at(const Band& band,
                        int32_t row,
                        int32_t column) noexcept {
  return is_up_to(row + 1, band.rows) ? band.row(row) + column : nullptr;
}

// The same of a flat edge. Returns the row above its last crossing.
inline int32_t paint_columns(const Band& band,
                             int32_t column,
                             int32_t end,
                             int32_t across,
                             int32_t slope,
                             int32_t half_bend,
                             int32_t above) noexcept {
  const int32_t stride = band.stride;
  uint8_t* bytes = pair_at(band, above, column);
  do {
    const int32_t row = across >> 16;
    if (row != above) {
      const bool was_in = !kIsSmall && bytes != nullptr;
      bytes = pair_at(band, row, column);
      if (was_in && bytes != nullptr && abs(row - above) == 1) {
        bytes[row < above ? stride : 0] ^= 1;
      } else {
        toggle_rows(band, column, above, row);
      }
      above = row;
    }
    if (bytes != nullptr) {
      int32_t nearness;
      const int32_t below = nearness_pair(across, slope, nearness);
      approach(bytes, nearness);
      approach(bytes + stride, below);
      ++bytes;
    }
    slope += half_bend;
    across += slope;
    slope += half_bend;
  } while (++column != end);
  return above;
}

// What a parabola may stray by from the curve, ten times; from 6 px on less, as
// outlines of large glyphs err by more themselves. [px, Q8]
constexpr uint32_t kStray = 110;
constexpr uint32_t kStrayIfLong = 70;
constexpr uint32_t kLong = 6 << 8;

// Whether a curve must be halved: it turns back or away from its axis, or
// strays from a parabola over its axis, by a tenth of dd_along times the bend
// over the length. Slopes at the ends are up to 1.5, what is told by those of
// an even curve, (d_across -+ dd_across) / d_along, and by how uneven it is.
// `across`: the magnitude of d_across. [px, Q8]
inline bool must_be_halved(int32_t d_along,
                           int32_t across,
                           int32_t dd_along,
                           int32_t dd_across) noexcept {
  const auto uneven = static_cast<uint32_t>(abs(dd_along));
  const uint32_t bend = static_cast<uint32_t>(abs(dd_across)) + uneven;
  const auto length = static_cast<uint32_t>(d_along);
  return bend > 16 &&
         (2 * (static_cast<uint32_t>(across) + bend) > 3 * length ||
          bend * uneven > (length > kLong ? kStrayIfLong : kStray) * length);
}

// Whether rows near an end are tips.
inline bool is_slanted(int32_t slope) noexcept {
  return !is_up_to(slope + kSlanted, 2 * kSlanted);
}

}  // namespace

bool paint_edge(const Band& band,
                const PixelPoint* points,
                bool is_bent) noexcept {
  const PixelPoint* begin = points;
  const PixelPoint* const end = points + 2;
  if (!band.is_whole &&
      is_outside(band, begin->y, points[is_bent ? 1 : 2].y, end->y)) {
    return true;
  }
  int32_t d_across = end->x - begin->x;
  int32_t d_along = end->y - begin->y;
  int32_t width = abs(d_across);
  const int32_t height = abs(d_along);
  const bool is_steep = height >= width;
  if ((is_steep ? d_along : d_across) < 0) {
    begin = end;
    d_across = -d_across;
    d_along = -d_along;
  }
  int32_t from = begin->y;
  int32_t across = begin->x;
  if (!is_steep) {
    from = begin->x;
    across = begin->y;
    swap(d_across, d_along);
    width = height;
  }
  int32_t dd_along = 0;
  int32_t dd_across = 0;
  if (is_bent) {
    const PixelPoint& control = points[1];
    dd_along = d_along - 2 * ((is_steep ? control.y : control.x) - from);
    dd_across = d_across - 2 * ((is_steep ? control.x : control.y) - across);
    if (must_be_halved(d_along, width, dd_along, dd_across)) {
      return false;
    }
  }
  if (__builtin_expect(!is_below(d_along - 1, kLengthLimit - 1), 0)) {
    return d_along == 0;
  }
  const Reciprocal over_length = reciprocal_of(static_cast<uint32_t>(d_along));
  const int32_t to = from + d_along;
  const int32_t last_across = across + d_across;
  int32_t slope = times(d_across, over_length);
  int32_t last_slope = slope;
  int32_t half_bend = 0;
  Tip tip;
  // What is shorter than a 10th of a pixel is straight. Longer curves, which
  // need not be halved, reach slopes of 2 at most: kSlopes ends there.
  if (is_bent && d_along > 24) {
    const int32_t turn =
        times(dd_across - (slope * dd_along >> 16), over_length);
    half_bend = times(turn >> 2, over_length) >> 6;
    slope -= turn;
    last_slope += turn;
    if (__builtin_expect(!is_up_to(half_bend + kSharp, 2 * kSharp), 0)) {
      tip = {from, across, slope, half_bend, from, to, is_steep};
      paint_sharp(band, tip, last_across, last_slope);
      return true;
    }
  }
  int32_t row = (from >> 8) + 1;
  int32_t above = across >> 8;
  if (is_slanted(slope)) {
    const int32_t in_row = from + kWithinEnd;
    if ((in_row & 255) < kWithinEnd + kBeyondEnd) {
      tip = {from, across, slope, half_bend, from, to, is_steep};
      above = paint_tip(band, tip, in_row >> 8, above);
      row = (in_row >> 8) + 1;
    }
  }
  int32_t stop = (to >> 8) + 1;
  const int32_t in_last = to + kBeyondEnd;
  const bool has_last =
      is_slanted(last_slope) && (in_last & 255) < kWithinEnd + kBeyondEnd;
  if (has_last) {
    stop = in_last >> 8;
  }
  const int32_t first_row = row;
  if (row < stop) {
    const int32_t u = row * 256 - from;
    const int32_t bent = half_bend * u >> 8;
    int32_t at = across * 256 + ((slope + bent) * u >> 8);
    int32_t slope_at = slope + 2 * bent;
    if (row < 0) {
      const int32_t count = min(stop, 0) - row;
      at += count * (slope_at + count * half_bend);
      slope_at += 2 * count * half_bend;
      row += count;
    }
    if (is_steep) {
      const int32_t until = min(stop, band.rows);
      if (row < until) {
        paint_rows(band, row, until, at, slope_at, half_bend);
      }
    } else {
      const int32_t until = min(stop, band.last_column + 1);
      if (row < until) {
        above = paint_columns(band, row, until, at, slope_at, half_bend, above);
      }
    }
  }
  if (has_last && stop >= first_row) {
    tip = {to, last_across, last_slope, half_bend, from, to, is_steep};
    above = paint_tip(band, tip, stop, above);
  }
  // Rounding may leave the last crossing beside the end.
  if (!is_steep && last_across >> 8 != above) {
    toggle_rows(band, (to >> 8) + 1, above, last_across >> 8);
  }
  return true;
}

}  // namespace inkcell::detail
