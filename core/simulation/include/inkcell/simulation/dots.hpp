// Discs of a few pixels.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::simulation {

/// A disc with a soft edge. Radius: 1/2 to 8 px.
void draw_dot(Q16_16 x, Q16_16 y, Q26_6 radius, const Sink& sink) noexcept;

/// The pixels that a dot may touch.
Rect dot_box(Q16_16 x, Q16_16 y, Q26_6 radius) noexcept;

}  // namespace inkcell::simulation
