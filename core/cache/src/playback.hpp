// Draws rows that are kept.
#pragma once

#include <stdint.h>

#include "inkcell/strip.hpp"
#include "row_codes.hpp"

namespace inkcell {
namespace detail {

// Draws the groups from `at` on, whose rows fill `box`, within the window. All
// of the box must lie within 2^30 px.
void replay(const uint8_t* at,
            Packing packing,
            const Rect& box,
            const Sink& sink) noexcept;

}  // namespace detail
}  // namespace inkcell
