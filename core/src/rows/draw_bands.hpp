// The way of all glyphs to pixels: band by band, from a source into a sink.
#pragma once

#include "inkcell/font.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text_style.hpp"
#include "inkcell/workspace.hpp"
#include "place/position.hpp"

namespace inkcell {
namespace detail {

// Draws a placed glyph of a font with a source. What it does is the same for
// any workspace; without one, or with a small one, it takes kLeastRam bytes of
// the stack, kLeastFittedRam if the style is fitted.
void draw_bands(const Font& font,
                uint16_t glyph,
                const TextStyle& style,
                const Placed& placed,
                const Sink& sink,
                const Workspace& workspace) noexcept;

// The pixels that draw_bands() may touch.
Rect band_box(const Font& font,
              uint16_t glyph,
              const TextStyle& style,
              const Placed& placed) noexcept;

}  // namespace detail
}  // namespace inkcell
