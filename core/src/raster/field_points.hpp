// Cells of primitives in pixel order: each pixel for itself, upright or not.
#pragma once

#include <stdint.h>

#include "inkcell/field.hpp"
#include "inkcell/text_style.hpp"
#include "raster/field_slanted.hpp"
#include "sink/span_writer.hpp"

namespace inkcell {
namespace detail {

// Draws the pixels of a row, all in the grid, given where the first one lies,
// which goes behind the last. `stretching` is null if edges are stretched
// alike.
void draw_points(const GlyphField& field,
                 const TextStyle& style,
                 const Stretching* stretching,
                 SlantedPoint& at,
                 Range row,
                 SpanWriter& writer) noexcept;

}  // namespace detail
}  // namespace inkcell
