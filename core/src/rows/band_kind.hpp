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
  // As in crossings.hpp: distances with fewer bits.
  crossings,
  // Differences of coverage from a sample to the next one, modulo 256; 240 is a
  // full sample. Samples are squares, or thirds of squares.
  area,
};

// Paints points of outlines into a band.
using PaintPoints = void(const Band& band,
                         OutlineCursor& cursor,
                         const ScreenPoint* points,
                         const ScreenPoint* end) noexcept;

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
