// Directions and matrices: how glyphs lie on the screen.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"

namespace inkcell {

/// A unit vector: the direction of the baseline, counter-clockwise from the
/// right as one sees it. {1, 0} is upright text; to Style a sine of 0 with a
/// positive cosine is exactly that.
struct Direction {
  Fixed<int32_t, 30> cosine = Fixed<int32_t, 30>::from_raw(1 << 30);
  Fixed<int32_t, 30> sine;
};

/// Any linear map: where a glyph's axes lead on the screen. [px to the em]
///
///     right = x_right x + y_right y     (x, y) is a place in the glyph, in em
///     up    = x_up    x + y_up    y
///
/// In px, {24, 0, 0, 24} is upright text, {24, 0, 5, 24} leans to the right,
/// {16, 0, 0, 24} is narrow, {-24, 0, 0, 24} is mirrored.
struct Matrix {
  Q16_16 x_right;
  Q16_16 x_up;
  Q16_16 y_right;
  Q16_16 y_up;
};

/// What one px on the screen is in the glyph: along its axes, in u and in px of
/// Style::size().
struct GlyphStep {
  int32_t x_q16;  // [u]
  int32_t y_q16;
  int32_t x_q20;  // [px]
  int32_t y_q20;
};

}  // namespace inkcell
