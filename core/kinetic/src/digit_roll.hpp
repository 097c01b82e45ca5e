// One digit rolls out of its cell, and the next one in.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/kinetic/recipes.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"

namespace inkcell {
namespace kinetic {

inline constexpr uint16_t kBlank = 0xffff;  // a wheel without a digit

/// `at` is the left end of the cell's baseline. A part of 0 draws `from`.
void draw_roll(const Painter& painter,
               const Face& face,
               const DigitCells& cells,
               Point at,
               const uint16_t (&digits)[2],
               Q16_16 part) noexcept;

/// The pixels of cells [first, last) from `at` on.
Rect cells_box(const DigitCells& cells,
               Point at,
               int32_t first,
               int32_t last) noexcept;

}  // namespace kinetic
}  // namespace inkcell
