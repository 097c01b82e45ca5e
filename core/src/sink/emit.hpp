// Blocks and rows of coverage, to a sink.
#pragma once

#include <stdint.h>

#include "inkcell/strip.hpp"

namespace inkcell {
namespace detail {

// Draws a block of coverage whose rows are `stride` bytes apart, and a row of
// one.
//
// All coverage of glyphs passes here but for that of sub-pixels that are mixed
// (effects/lcd.cpp) and of type that moves (kinetic/src/pixel_run.hpp). Both
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
// A block of three coverages a pixel.
void emit_rgb(const Sink& sink,
              const Rect& pixels,
              const uint8_t* coverage,
              int32_t stride) noexcept;

}  // namespace detail
}  // namespace inkcell
