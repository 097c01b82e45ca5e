// Rows of coverage as a cache keeps them: without what is empty, and each row
// once where rows are equal.
//
//   glyph  group...
//   group  a byte: the number of equal rows less 1 (high 3 bits) and of bytes
//          of its steps (low 5 bits; 31: that and more are in the next byte),
//          steps
//   step   a byte: pixels to skip (high 4 bits), then pixels to draw (low 4
//          bits). 0 to 14: their coverage follows, one value a channel, of 4
//          bits (low ones first, filled up to a byte) or of 8. 15: they are
//          solid, and a byte with their number follows.
#pragma once

#include <stdint.h>

#include "inkcell/strip.hpp"

namespace inkcell {
namespace detail {

// How a pixel is kept.
struct Packing {
  uint8_t bits;      // 4 or 8
  uint8_t channels;  // 1, or 3 for sub-pixels
};

// The most values of a row: its steps then have 255 bytes or fewer.
inline constexpr int32_t kMostRowBytes = 192;

// The most bytes that a row takes.
int32_t most_row_bytes(int32_t width, Packing packing) noexcept;

// Adds a row to the groups that end at `end`, of which the last one begins at
// `last`; null: there is none. Returns their new end; where that is the old one
// the last group has one row more.
uint8_t* record_row(const uint8_t* coverage,
                    int32_t width,
                    Packing packing,
                    uint8_t* last,
                    uint8_t* end) noexcept;

// Draws the groups from `at` to `end`, whose first row begins at (x, y). All
// of that must lie within 2^30 px. Three bytes behind the end may be read.
void replay(const uint8_t* at,
            const uint8_t* end,
            Packing packing,
            int32_t x,
            int32_t y,
            const Sink& sink) noexcept;

}  // namespace detail
}  // namespace inkcell
