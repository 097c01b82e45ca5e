// Areas in rows of 16 bits, where contours may overlap and run in any
// direction: what the sums of 136 contours on each other are is kept, and
// saturates later.
//
// Rows of 16 bits begin where the band does and have as many pixels: they take
// twice the bytes of its rows, all 0 before.
#pragma once

#include "rows/band.hpp"

namespace inkcell::detail {

PaintPoints paint_wide_areas;

// What that left at `wide`, to coverage in the band's rows of bytes, which may
// begin there, too.
void cover_wide_rows(const Band& band, const uint8_t* wide) noexcept;
// The same of rows that begin there. The filter is not looked at.
void cover_wide_areas(const Band& band, const Filter& filter) noexcept;

}  // namespace inkcell::detail
