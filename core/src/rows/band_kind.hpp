// What a filter or an effect takes: a kind of band.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"
#include "outlines/screen_point.hpp"
#include "rows/band.hpp"

namespace inkcell::detail {

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
  bool is_ramp;  // cover() is what Sink::ramp does
  // How far from the edge bytes differ from 0; 0: as far as the ramp of the
  // filter, see BandPlan. [px, Q8]
  uint8_t reach_q8;
};

extern const BandKind kCrossingBand;  // only a mixer can name it

}  // namespace inkcell::detail
