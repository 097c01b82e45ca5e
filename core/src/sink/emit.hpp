// Blocks and rows of coverage, to a sink.
#pragma once

#include <stdint.h>

#include "inkcell/strip.hpp"

namespace inkcell {
namespace detail {

// Hands on a block of coverage whose rows are `stride` bytes apart, and a row
// of one.
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

}  // namespace detail
}  // namespace inkcell
