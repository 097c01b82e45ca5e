// The rows of pixels that an outline is painted into, a byte a pixel: what
// paints them, what makes coverage of them, and what hands that to a sink.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/strip.hpp"
#include "outlines/screen_point.hpp"

namespace inkcell::detail {

struct GlyphJob;

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
// their curve. Painters of distances reach as far `above` as `below`. [px, Q8]
constexpr int32_t kAboveBand = 256 + 32;
constexpr int32_t kBelowBand = 32;
inline bool is_outside(const Band& band,
                       int32_t y0,
                       int32_t y1,
                       int32_t y2,
                       int32_t above = kAboveBand,
                       int32_t below = kBelowBand) noexcept {
  const int32_t end = band.rows * 256 + below;
  return (((y0 + above) & (y1 + above) & (y2 + above)) |
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

// What the bytes of a painted band are.
enum class BandBytes : uint8_t {
  // Bits 1 to 7: nearness to the edge, 254 on the edge and 0 from the band's
  // reach on. Bit 0: the edge passes between this sample and the one to the
  // left. Samples lie at centres of pixels.
  distance,
  // Distances with fewer bits, by kInsideBit and so on.
  crossings,
  // Differences of coverage from a sample to the next one, modulo 256; 240 is a
  // full sample. Samples are squares, or thirds of squares.
  area,
};

// Bytes of crossings: the lowest bit toggles from outside to inside and back;
// the next two say whether the outline crosses the straight line from the
// centre of the pixel to the left, and of that above; the rest is nearness.
inline constexpr uint32_t kInsideBit = 1;
inline constexpr uint32_t kCrossedLeft = 2;
inline constexpr uint32_t kCrossedAbove = 4;
inline constexpr uint32_t kNearnessMask = 0xf8;

// Paints points of outlines into a band.
using PaintPoints = void(const Band& band,
                         OutlineCursor& cursor,
                         const ScreenPoint* points,
                         const ScreenPoint* end) noexcept;

// Exact areas; pixels begin at whole numbers.
PaintPoints paint_areas;
// Distances within half a pixel of the edge; centres of pixels lie at whole
// numbers, here and below.
PaintPoints paint_distances;
// Up to band.reach_q8, 4 px: for wide ramps, weights, strokes and glows.
PaintPoints paint_wide_distances;
// The same with crossings of rows and columns, for pictures without greys.
PaintPoints paint_crossings;

// A filter names one, and so does a mixer. Sources other than outlines look at
// `bytes` and `reach_q8` only.
struct BandKind {
  // Null in a program that opens no font of outlines.
  PaintPoints* paint;
  // Painted rows to coverage, in place. Null: only a mixer can.
  void (*cover)(const Band& band, const Filter& filter) noexcept;
  BandBytes bytes;
  Painted painted;  // what Sink::painted makes as cover() does
  // How far from the edge bytes differ from 0; 0: as far as the ramp of the
  // filter, see BandPlan. [px, Q8]
  uint8_t reach_q8;
};

extern const BandKind kCrossingBand;  // only a mixer can name it

inline void approach(uint8_t* pixel, int32_t nearness) noexcept {
  const int32_t old = *pixel;
  if (old < nearness) {
    *pixel = static_cast<uint8_t>(nearness | (old & 1));
  }
}

// The line from points[0] to points[2], or the curve with `is_bent`; not the
// pixels nearest to its ends. False, and nothing is done, if it must be halved
// before.
bool paint_edge(const Band& band,
                const PixelPoint* points,
                bool is_bent) noexcept;

// The painted band to the sink.
void emit_band(GlyphJob& job) noexcept;

// What paint_areas left. The filter is not looked at.
void cover_areas(const Band& band, const Filter& filter) noexcept;

// What paint_distances left; coverage of Filter::is_linear_pixel().
void cover_linear(const Band& band, const Filter& filter) noexcept;

// What paint_distances or paint_wide_distances left; coverage of `filter`,
// whose ramp lies within the band's reach.
void cover_filtered(const Band& band, const Filter& filter) noexcept;

// Draws a block of coverage whose rows are `stride` bytes apart, and a row of
// one.
//
// All coverage of glyphs passes here but for that of sub-pixels that are mixed
// (effects/lcd.cpp) and of simulations (simulation/src/pixel_run.hpp). Both
// find runs while they make pixels. emit_row() would look for them once more.
void emit(const Sink& sink,
          const Rect& pixels,
          const uint8_t* coverage,
          int32_t stride) noexcept;
// `coverage` lies at a multiple of 4 where x is one.
void emit_row(const Sink& sink,
              int32_t x,
              int32_t y,
              const uint8_t* coverage,
              int32_t count) noexcept;

}  // namespace inkcell::detail
