// Glyphs of a run on their way to the band by band drawing.
#pragma once

#include <stdint.h>

#include "inkcell/painter.hpp"
#include "place/position.hpp"

namespace inkcell {
namespace detail {

// Room for a style that the sink adapts.
union StyleRoom {
  StyleRoom() noexcept {}
  Style& style() noexcept { return style_; }

 private:
  Style style_;
};

// What kDrawPlain does.
void draw_plain(GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept;

// The nearest place at which a drawer draws glyphs.
inline Placed at_phase(Placed placed, uint32_t phase_shift) noexcept {
  const int32_t half = (1 << phase_shift) >> 1;
  const auto nearest = [=](int32_t q10) noexcept {
    return (q10 + half) & -(1 << phase_shift);
  };
  return {nearest(placed.x_q10), nearest(placed.y_q10)};
}

// The box of a glyph, at that place.
Rect box_of(const GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept;

}  // namespace detail
}  // namespace inkcell
