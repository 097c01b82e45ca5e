// Keeps the rows of a glyph.
#pragma once

#include <stdint.h>

#include "row_codes.hpp"

namespace inkcell {
namespace detail {

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

}  // namespace detail
}  // namespace inkcell
