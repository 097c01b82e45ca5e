// Cells of samples in object order.
#pragma once

#include "raster/field_draw.hpp"

namespace inkcell {
namespace detail {

// Draws an upright glyph, bit by bit as rows would.
void draw_samples_by_cells(const GlyphField& field,
                           const TextStyle& style,
                           const Placed& placed,
                           const Sink& sink) noexcept;

}  // namespace detail
}  // namespace inkcell
