// An edge on its way through rows or columns of a band.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "rows/band.hpp"

namespace inkcell {
namespace detail {

inline void approach(uint8_t* pixel, int32_t nearness) noexcept {
  const int32_t old = *pixel;
  if (old < nearness) {
    *pixel = static_cast<uint8_t>(nearness | (old & 1));
  }
}

// The length of a vector, doubled: max(a, 7/8 a + 1/2 b), within 3 %.
inline int32_t doubled_length(int32_t x, int32_t y) noexcept {
  int32_t longer = abs(x);
  int32_t shorter = abs(y);
  if (longer < shorter) {
    const int32_t swapped = longer;
    longer = shorter;
    shorter = swapped;
  }
  const int32_t slanted = (longer * 7 >> 2) + shorter;
  return slanted > 2 * longer ? slanted : 2 * longer;
}

// Bits of Edge::ends.
enum : uint32_t {
  // A corner, which has a vertex.
  kCornerBefore = 1,
  kCornerAfter = 2,
  // Tips, where the nearest point may be an end: the first row, the last one,
  // all rows.
  kFirstTip = 4,
  kLastTip = 8,
  kAllTips = 16
};

// An edge along its longer axis: rows if it is steep, columns if it is flat.
// All along the axis comes first. [px, Q8; across Q16]
struct Edge {
  int32_t from;    // where it begins
  int32_t length;  // above 0
  int32_t first;   // rows to paint: first <= row < end
  int32_t end;
  int32_t across;  // where it crosses the row at hand, `first` to begin with
  int32_t slope;
  int32_t half_bend;  // what the slope gains in half a row
  int32_t half_jerk;  // what that gains in a row
  uint32_t ends;
  // Where it begins and ends: beyond that it goes on straight. [Q8; Q16]
  int32_t across_before;
  int32_t across_after;
  int32_t slope_before;
  int32_t slope_after;

  void step() noexcept {
    slope += half_bend;
    across += slope;
    half_bend += half_jerk;
    slope += half_bend;
  }
  // The same as `count` steps.
  void step(int32_t count) noexcept {
    across += count * (slope + count * half_bend) +
              (count - 1) * count * (count + 1) / 3 * half_jerk;
    slope += count * (2 * half_bend + count * half_jerk);
    half_bend += count * half_jerk;
  }
};

// The rows of a steep edge, the columns of a flat one. `edge` is used up.
void paint_steep(const Band& band, Edge& edge) noexcept;
void paint_flat(const Band& band, Edge& edge) noexcept;

}  // namespace detail
}  // namespace inkcell
