// One digit rolls out of its cell, and the next one in.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"

namespace inkcell::motion {

/// Cells of digits, one beside the other. Made by measure_digits().
struct DigitCells {
  Q26_6 width;         // of the widest digit's advance [px]
  int32_t top = 0;     // of a cell, from the baseline [px, y down]
  int32_t bottom = 0;  // exclusive; digits roll by bottom - top
  int32_t left = 0;    // how far ink overhangs a cell [px, <= 0]
  int32_t right = 0;   // likewise [px, >= 0]
};
/// The cell that holds each digit of a font.
DigitCells measure_digits(const Font& font, const Style& style) noexcept;

/// A cell without a digit.
inline constexpr uint16_t kBlank = 0xffff;

/// Draws digits[0] moved up by a part of the cell's height, and digits[1],
/// which follows it, below: glyphs, or kBlank. `at` is the left end of the
/// cell's baseline. A part of 0 draws digits[0].
void draw_roll(const Painter& painter,
               const Face& face,
               const DigitCells& cells,
               Point at,
               const uint16_t (&digits)[2],
               Q16_16 part) noexcept;

/// The pixels of cells [first, last) from `at` on, with ink that overhangs.
Rect cells_box(const DigitCells& cells,
               Point at,
               int32_t first,
               int32_t last) noexcept;

}  // namespace inkcell::motion
