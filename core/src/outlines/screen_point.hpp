// A point of an outline on the screen.
#pragma once

#include <stdint.h>

#include "inkcell/geometry.hpp"

namespace inkcell::detail {

// What a point of an outline is to the one before it. The first three are the
// kinds of code words (format::outline).
enum PointKind : uint8_t {
  kOffCurve = 0,
  kSmooth = 1,  // on the curve, no corner
  kCorner = 2,
  kStart = 3  // a corner where a contour begins
};

// The column that points count from, given the box of their glyph. It is a
// multiple of 4 and lies before the box; rows count from the box's first one.
inline int32_t first_column(const Rect& box) noexcept {
  return (box.x0 - 1) & ~3;
}

// Relative to first_column() and the first row of a glyph's box; y down. A
// contour is a start and the points after it, the last one where it started.
// Lies in RAM that is lent as bytes.
struct __attribute__((may_alias)) ScreenPoint {
  int32_t x_q8;       // [px]
  int32_t y_q8_kind;  // [px], and below it two bits of kind

  static ScreenPoint at(int32_t x_q8, int32_t y_q8, uint32_t kind) noexcept {
    return {x_q8,
            static_cast<int32_t>(static_cast<uint32_t>(y_q8) << 2 | kind)};
  }
  int32_t y_q8() const noexcept { return y_q8_kind >> 2; }
  uint32_t kind() const noexcept {
    return static_cast<uint32_t>(y_q8_kind) & 3;
  }
};

}  // namespace inkcell::detail
