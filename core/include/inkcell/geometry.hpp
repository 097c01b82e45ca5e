// Points and rectangles on the screen: x to the right, y down.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"

namespace inkcell {

/// A half-open rectangle of pixels: x0 <= x < x1, y0 <= y < y1.
/// Empty when x1 <= x0 or y1 <= y0.
struct Rect {
  int32_t x0 = 0;
  int32_t y0 = 0;
  int32_t x1 = 0;
  int32_t y1 = 0;
};

/// The common part of two rectangles; empty when they do not meet.
constexpr Rect intersect(const Rect& a, const Rect& b) noexcept {
  return {a.x0 > b.x0 ? a.x0 : b.x0, a.y0 > b.y0 ? a.y0 : b.y0,
          a.x1 < b.x1 ? a.x1 : b.x1, a.y1 < b.y1 ? a.y1 : b.y1};
}

/// Whether a rectangle holds no pixel.
constexpr bool is_empty(const Rect& r) noexcept {
  return r.x1 <= r.x0 || r.y1 <= r.y0;
}

/// The smallest rectangle that holds both; an empty one adds nothing.
constexpr Rect bounding_box(const Rect& a, const Rect& b) noexcept {
  if (is_empty(a) || is_empty(b)) {
    return is_empty(a) ? b : a;
  }
  return {a.x0 < b.x0 ? a.x0 : b.x0, a.y0 < b.y0 ? a.y0 : b.y0,
          a.x1 > b.x1 ? a.x1 : b.x1, a.y1 > b.y1 ? a.y1 : b.y1};
}

/// A place on the screen in px, y down: {4, 28} or {4.5_px, 28_px}.
struct Point {
  Q26_6 x;
  Q26_6 y;

  constexpr Point() noexcept = default;
  constexpr Point(Q26_6 x_px, Q26_6 y_px) noexcept : x(x_px), y(y_px) {}
  /// Whole px, as Q26_6::from_int() takes them.
  constexpr Point(int32_t x_px, int32_t y_px) noexcept
      : x(Q26_6::from_int(x_px)), y(Q26_6::from_int(y_px)) {}
};

/// The same, finer and wider: how glyphs of a run are placed. [px, Q10] At most
/// 2^60 in magnitude.
struct FinePoint {
  int64_t x_q10 = 0;
  int64_t y_q10 = 0;

  constexpr FinePoint() noexcept = default;
  constexpr FinePoint(int64_t x, int64_t y) noexcept : x_q10(x), y_q10(y) {}
  constexpr FinePoint(Point p) noexcept
      : x_q10(int64_t{p.x.raw} * 16), y_q10(int64_t{p.y.raw} * 16) {}
};

}  // namespace inkcell
