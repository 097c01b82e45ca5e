// Rows of coverage as a cache keeps them: eight values at a time, without pairs
// that are empty or solid, and each row once where rows are equal.
//
//   glyph  group...
//   group  equal rows: a byte, and eight values; then for each sixteen further
//          ones a byte, and the values. The first byte holds the number of rows
//          less 1 (low 4 bits) and a code, the others two.
//   code   4 bits, the first one lowest: which pairs of an eight are empty,
//          solid, or mixed. The values of mixed pairs follow.
//   pair   a byte (values of 4 bits, low ones first) or two (8 bits)
//
// Where all pairs are mixed the values of 4 bits are four bytes, 0 to 3 in the
// low halves and 4 to 7 in the high ones. A pixel has one value, or one a
// channel. A row is filled up with empty ones.
#pragma once

#include <stdint.h>

#include "inkcell/strip.hpp"

namespace inkcell::detail {

// How a pixel is kept.
struct Packing {
  uint8_t bits;      // 4 or 8
  uint8_t channels;  // 1, or 3 for sub-pixels
};

// The most values of a row.
inline constexpr int32_t kMostRowValues = 192;

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

// Draws the groups from `at` on, whose rows fill `box`, within the window. All
// of the box must lie within 2^30 px.
void replay(const uint8_t* at,
            Packing packing,
            const Rect& box,
            const Sink& sink) noexcept;

}  // namespace inkcell::detail
