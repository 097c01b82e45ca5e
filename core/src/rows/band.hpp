// The rows of pixels that an outline is painted into, a byte a pixel.
#pragma once

#include <stdint.h>

#include "outlines/screen_point.hpp"

namespace inkcell::detail {

// Some rows and columns of a glyph. Painters write whatever lies in it and
// leave out the rest, so that a picture does not depend on how a glyph is cut
// into bands. All bytes are 0 before.
//
//        0   1 .. last_column  last_column + 1
//   -1   .   .       .             .             guards: the second pixel of a
//    0   .  pixel  pixel           .             pair may lie there
//   ...
//  rows  .   .       .             .
struct Band {
  // First: the smallest cores reach few bytes by their offset.
  bool is_whole;     // nothing of the glyph lies above or below
  bool is_mirrored;  // filled areas lie to the right of contours, not the left
  int32_t stride;    // [bytes], a multiple of 4
  uint8_t* bytes;    // of row 0
  int32_t rows;
  int32_t last_column;
  // Where column 0 and row 0 lie among the glyph's. [px, Q8]
  int32_t x_q8;
  int32_t y_q8;
  // How far distances are good outside and inside, the greater of the two, and
  // what nearness falls by in a px / 256 up to there. [px, Q8; Q14] Painters of
  // fixed reach have constants.
  int32_t outside_q8;
  int32_t inside_q8;
  int32_t reach_q8;
  int32_t fall_q14;

  // The words that hold pixels of a row. [bytes]
  int32_t row_bytes() const noexcept { return (last_column | 3) + 1; }
  uint8_t* row(int32_t i) const noexcept { return bytes + i * stride; }
};

struct PixelPoint {
  int32_t x;  // [px, Q8]
  int32_t y;
};

// Whether an edge between these heights touches no row, not even as the second
// of a pair. An 8th of a pixel is room for roundings and for chords outside of
// their curve.
constexpr int32_t kAboveBand = 256 + 32;
constexpr int32_t kBelowBand = 32;
inline bool is_outside(const Band& band,
                       int32_t y0,
                       int32_t y1,
                       int32_t y2) noexcept {
  const int32_t end = band.rows * 256 + kBelowBand;
  return (((y0 + kAboveBand) & (y1 + kAboveBand) & (y2 + kAboveBand)) |
          ((end - y0) & (end - y1) & (end - y2))) < 0;
}

// The same of a height.
inline bool is_outside(const Band& band, int32_t y) noexcept {
  return static_cast<uint32_t>(y + kAboveBand) >
         static_cast<uint32_t>(band.rows * 256 + kAboveBand + kBelowBand);
}

// The last point on the curve that `at`, which is one, leads to without
// touching a row: `at` itself, if the next edges may.
const ScreenPoint* skip_outside(const Band& band,
                                const ScreenPoint* at,
                                const ScreenPoint* end) noexcept;

// Curves are halved so often at most: 16 pieces.
inline constexpr uint32_t kHalvings = 4;

// How far a painter has come in a glyph's points, which come in portions.
struct OutlineCursor {
  static constexpr uint32_t kEdge = 2 * kHalvings;

  bool is_bent;
  uint8_t corner_at;  // 1: the edge begins at a corner
  PixelPoint points[kEdge + 3];

  // The edge at hand: where it begins, its control point with `is_bent`, and
  // room for its end. Set by a contour's start. Halves of curves lie before it.
  PixelPoint* edge() noexcept { return points + kEdge; }

  // For painters that reach far and halve nothing: where the contour began, its
  // first direction, and that at the edge's beginning; zeros if there is none
  // yet.
  PixelPoint& start() noexcept { return points[0]; }
  PixelPoint& first() noexcept { return points[1]; }
  PixelPoint& before() noexcept { return points[2]; }

  // For those that halve nothing and need none of that: the edge comes first,
  // and what lies behind it is free.
  PixelPoint* first_edge() noexcept { return points; }
  PixelPoint* halves() noexcept { return points + 3; }

  // All else is set by the start of a contour.
  void begin(bool halves_nothing) noexcept {
    PixelPoint* const at = halves_nothing ? first_edge() : edge();
    at[0] = {0, 0};
    at[1] = {0, 0};
    is_bent = false;
    corner_at = 0;
  }
};

}  // namespace inkcell::detail
