// Pixels beside an edge, row by row or column by column; near its ends, and
// where it bends sharply, each as far away as the nearest point.
#include "rows/edge_rows.hpp"

#include "base/math.hpp"

namespace inkcell {
namespace detail {
namespace {

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

// How far an edge leaves its tangent on the way to a foot. [px, Q8; 1/508 px]
inline int32_t sag_of(int32_t half_bend, int32_t foot, int32_t fall) noexcept {
  return ((half_bend >> 7) * (foot * foot) >> 10) * fall >> 15;
}

// Where an edge crosses a row near one of its ends: beyond it, its tangent
// there does.
struct Crossing {
  int32_t before;  // the row, from where the edge begins [px, Q8]
  int32_t at;      // where the tangent touches, likewise
  int32_t across;
  int32_t slope;

  Crossing(const Edge& edge, int32_t row) noexcept
      : before(row * 256 - edge.from),
        at(before),
        across(edge.across),
        slope(edge.slope) {
    if (before < 0) {
      at = 0;
      slope = edge.slope_before;
      across = edge.across_before * 256 + (slope * before >> 8);
    } else if (before > edge.length) {
      at = edge.length;
      slope = edge.slope_after;
      across = edge.across_after * 256 + (slope * (before - at) >> 8);
    }
  }
};

// The pixel beside a crossing, `across` [px, Q8]. The foot of its tangent lies
// `foot` behind where the edge begins [px, Q8], `distance` away. [1/508 px]
inline void paint_beside(uint8_t* pixel,
                         const Edge& edge,
                         const Crossing& crossing,
                         int32_t across,
                         int32_t foot,
                         int32_t distance) noexcept {
  if (static_cast<uint32_t>(foot) > static_cast<uint32_t>(edge.length)) {
    const bool is_before = foot < 0;
    if (edge.ends & (is_before ? kCornerBefore : kCornerAfter)) {
      return;
    }
    distance =
        is_before ? doubled_length(crossing.before, across - edge.across_before)
                  : doubled_length(crossing.before - edge.length,
                                   across - edge.across_after);
  }
  approach(pixel, 254 - (max(distance, 0) & ~1));
}

// The pair of pixels of a row near an end of the edge: `pixel` and the one
// `stride` behind it, as far from the edge as the nearest of its points is.
__attribute__((noinline)) void paint_tip(uint8_t* pixel,
                                         int32_t stride,
                                         const Edge& edge,
                                         const Crossing& crossing) noexcept {
  const int32_t slope = min(abs(in_32nds(crossing.slope)), Slopes::kMost);
  const int32_t fall = kSlopes.cosines[Slopes::kMost + slope] * 2;
  const int32_t sine_cosine = kSlopes.sine_cosines[slope];
  const int32_t along = crossing.slope < 0 ? -sine_cosine : sine_cosine;
  const auto f = static_cast<uint32_t>(crossing.across & 0xffff);
  int32_t across = (crossing.across >> 16) * 256;
  int32_t foot = crossing.before - (static_cast<int32_t>(f) * along >> 16);
  int32_t distance =
      static_cast<int32_t>(f * static_cast<uint32_t>(fall) >> 16);
  const int32_t other = fall - distance;
  const int32_t half_bend = edge.half_bend;
  if (half_bend != 0) {
    distance += sag_of(half_bend, foot - crossing.at, fall);
  }
  paint_beside(pixel, edge, crossing, across, foot, distance);
  foot += along;
  distance = other;
  if (half_bend != 0) {
    distance -= sag_of(half_bend, foot - crossing.at, fall);
  }
  paint_beside(pixel + stride, edge, crossing, across + 256, foot, distance);
}

// A row near an end of a steep edge.
__attribute__((noinline)) void paint_steep_tip(const Band& band,
                                               const Edge& edge,
                                               int32_t row) noexcept {
  if (static_cast<uint32_t>(row) >= static_cast<uint32_t>(band.rows)) {
    return;
  }
  const Crossing crossing(edge, row);
  const int32_t column = crossing.across >> 16;
  const bool is_crossed = crossing.before > 0 && edge.length >= crossing.before;
  uint8_t* const bytes = band.row(row);
  if (static_cast<uint32_t>(column) <=
      static_cast<uint32_t>(band.last_column)) {
    paint_tip(bytes + column, 1, edge, crossing);
    bytes[column + 1] ^= is_crossed ? 1 : 0;
  } else if (column < 0) {
    bytes[0] ^= is_crossed ? 1 : 0;
  }
}

// The pixels on both sides of a crossing lie at f and 1 - f of a pixel from it,
// so that they are f cos a and (1 - f) cos a away from the edge. `nearness` is
// that of the first, the result that of the second: their ways add up to
// 508 cos a, what nearness falls by in a pixel.
inline int32_t nearness_pair(int32_t across,
                             int32_t slope,
                             int32_t& nearness) noexcept {
  const uint32_t cosine = (kSlopes.cosines + Slopes::kMost)[in_32nds(slope)];
  const auto way = static_cast<int32_t>(
      (static_cast<uint32_t>(across) & 0xffff) * cosine >> 16);
  nearness = 254 - 2 * way;
  return 2 * (127 - static_cast<int32_t>(cosine) + way);
}

// Rows without tests.
inline void paint_steep_rows(const Band& band,
                             Edge& edge,
                             int32_t row,
                             int32_t count) noexcept {
  const auto last_column = static_cast<uint32_t>(band.last_column);
  const int32_t stride = band.stride;
  const int32_t half_jerk = edge.half_jerk;
  int32_t half_bend = edge.half_bend;
  uint8_t* bytes = band.row(row);
  int32_t across = edge.across;
  int32_t slope = edge.slope;
  do {
    const int32_t column = across >> 16;
    if (__builtin_expect(static_cast<uint32_t>(column) <= last_column, 1)) {
      uint8_t* const pixel = bytes + column;
      int32_t nearness;
      const int32_t behind = nearness_pair(across, slope, nearness);
      approach(pixel, nearness);
      int32_t old = pixel[1];
      if (old < behind) {
        old = behind | (old & 1);
      }
      pixel[1] = static_cast<uint8_t>(old ^ 1);
    } else if (column < 0) {
      bytes[0] ^= 1;
    }
    slope += half_bend;
    across += slope;
    half_bend += half_jerk;
    slope += half_bend;
    bytes += stride;
  } while (--count != 0);
  if (edge.ends & kLastTip) {
    edge.across = across;
    edge.slope = slope;
    edge.half_bend = half_bend;
  }
}

}  // namespace

void paint_steep(const Band& band, Edge& edge) noexcept {
  int32_t row = edge.first;
  int32_t last = edge.end;  // the row of the second tip
  if (edge.ends & kLastTip) {
    --last;
  }
  if (edge.ends & kFirstTip) {
    paint_steep_tip(band, edge, row);
    if (row == last) {
      return;
    }
    ++row;
    edge.step();
  }
  if (row < 0) {
    const int32_t count = min(last, 0) - row;
    if (count > 0) {
      edge.step(count);
      row += count;
    }
  }
  const int32_t end = min(last, band.rows);
  if (row < end && (edge.ends & kAllTips) != 0) {
    for (; row != end; ++row) {
      paint_steep_tip(band, edge, row);
      edge.step();
    }
  } else if (row < end) {
    paint_steep_rows(band, edge, row, end - row);
    row = end;
  }
  if ((edge.ends & kLastTip) != 0 && row == last) {
    paint_steep_tip(band, edge, row);
  }
}

namespace {

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

// A column near an end of a flat edge. `above`: the row above the edge so far.
// Returns that of the next one.
__attribute__((noinline)) int32_t paint_flat_tip(const Band& band,
                                                 const Edge& edge,
                                                 int32_t column,
                                                 int32_t above) noexcept {
  const Crossing crossing(edge, column);
  const int32_t row = crossing.across >> 16;
  if (row != above && crossing.before > 0 && edge.length >= crossing.before) {
    toggle_rows(band, column, above, row);
    above = row;
  }
  if (static_cast<uint32_t>(row + 1) <= static_cast<uint32_t>(band.rows) &&
      static_cast<uint32_t>(column) <=
          static_cast<uint32_t>(band.last_column)) {
    paint_tip(band.row(row) + column, band.stride, edge, crossing);
  }
  return above;
}

// Columns without tests.
inline void paint_flat_columns(const Band& band,
                               Edge& edge,
                               int32_t column,
                               int32_t end,
                               int32_t& row_above) noexcept {
  const auto rows = static_cast<uint32_t>(band.rows);
  const int32_t stride = band.stride;
  const int32_t half_jerk = edge.half_jerk;
  int32_t half_bend = edge.half_bend;
  int32_t across = edge.across;
  int32_t slope = edge.slope;
  int32_t above = row_above;
  // The row above the edge; null if the band has no part of the pair.
  uint8_t* bytes = static_cast<uint32_t>(above + 1) <= rows
                       ? band.row(above) + column
                       : nullptr;
  do {
    const int32_t row = across >> 16;
    if (row != above) {
      const bool was_in = bytes != nullptr;
      bytes = static_cast<uint32_t>(row + 1) <= rows ? band.row(row) + column
                                                     : nullptr;
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
    half_bend += half_jerk;
    slope += half_bend;
  } while (++column != end);
  if (edge.ends & kLastTip) {
    edge.across = across;
    edge.slope = slope;
    edge.half_bend = half_bend;
  }
  row_above = above;
}

}  // namespace

void paint_flat(const Band& band, Edge& edge) noexcept {
  int32_t above = edge.across_before >> 8;
  int32_t column = edge.first;
  int32_t last = edge.end;  // the column of the second tip
  if (edge.ends & kLastTip) {
    --last;
  }
  if (edge.ends & kFirstTip) {
    above = paint_flat_tip(band, edge, column, above);
    edge.step();
    ++column;
  }
  if (column < 0) {
    const int32_t count = min(last, 0) - column;
    if (count > 0) {
      edge.step(count);
      column += count;
    }
  }
  const int32_t end = min(last, band.last_column + 1);
  if (column < end && (edge.ends & kAllTips) != 0) {
    for (; column != end; ++column) {
      above = paint_flat_tip(band, edge, column, above);
      edge.step();
    }
  } else if (column < end) {
    paint_flat_columns(band, edge, column, end, above);
    column = end;
  }
  if ((edge.ends & kLastTip) != 0 && column == last) {
    above = paint_flat_tip(band, edge, column, above);
  }
  // Rounding may leave the last crossing beside the end.
  const int32_t below = edge.across_after >> 8;
  if (below != above) {
    toggle_rows(band, ((edge.from + edge.length) >> 8) + 1, above, below);
  }
}

}  // namespace detail
}  // namespace inkcell
