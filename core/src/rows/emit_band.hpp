// Painted rows to coverage, in place, and coverage to a sink.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/strip.hpp"
#include "rows/band.hpp"

namespace inkcell::detail {

struct GlyphJob;

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
