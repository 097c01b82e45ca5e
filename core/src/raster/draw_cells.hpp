// Glyphs of cells, tile by tile.
#pragma once

#include "inkcell/field.hpp"
#include "inkcell/render.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text_style.hpp"
#include "place/position.hpp"

namespace inkcell {
namespace detail {

// Draws without a painter.
void draw_plain(const GlyphField& field,
                const TextStyle& style,
                const Placed& placed,
                const Sink& sink) noexcept;

// The pixels of the window that a painter may touch.
Rect visible_pixels(const GlyphField& field,
                    const TextStyle& style,
                    const FinePoint& origin,
                    const Rect& window) noexcept;

// draw_field of what is placed.
inline void draw_near(const GlyphField& field,
                      const TextStyle& style,
                      const Placed& placed,
                      const Sink& sink) noexcept {
  const CellEffect painter = style.effect().cells;
  if (painter != nullptr) {
    painter(field, style, style.effect().options, placed.origin(), sink);
  } else {
    draw_plain(field, style, placed, sink);
  }
}

}  // namespace detail
}  // namespace inkcell
