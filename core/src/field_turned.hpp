// Slanted rows: glyphs that do not stand upright.
#pragma once

#include "inkcell/brush.hpp"
#include "inkcell/render.hpp"

namespace inkcell {
namespace detail {

// A Painter of brushes that are not upright, without options.
void paint_turned(const GlyphField& field,
                  const Brush& brush,
                  const void* options,
                  const FinePoint& origin,
                  const RowMap* rows,
                  const Sink& sink) noexcept;

}  // namespace detail
}  // namespace inkcell
