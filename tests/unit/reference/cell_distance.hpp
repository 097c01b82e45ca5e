// The plain twin of what draws cells: each pixel for itself, from the numbers
// of its leaf's record, as docs/FORMAT.md has them, with the device's
// roundings.
#pragma once

#include "inkcell/field.hpp"
#include "inkcell/render.hpp"
#include "inkcell/text_style.hpp"

namespace reference {

/// The signed distance at the centre of pixel (x, y) of a style that does not
/// stretch. [px, Q10]
int32_t distance_q10(const inkcell::GlyphField& field,
                     const inkcell::TextStyle& style,
                     inkcell::FinePoint origin,
                     int32_t x,
                     int32_t y);

}  // namespace reference
