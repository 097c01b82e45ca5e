// Draws any glyph: band by band, from a source into a sink.
#pragma once

#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "inkcell/workspace.hpp"
#include "place/position.hpp"
#include "rows/source.hpp"

namespace inkcell::detail {

// Draws a placed glyph. The picture is the same for any workspace. One of
// kLeastFittedRam bytes holds all; one of more than kWideBandRam points and
// bands; what a smaller one does not hold lies on the stack.
void draw_bands(const GlyphRef& ref,
                const Style& style,
                const Placed& placed,
                const Sink& sink,
                const Workspace& workspace) noexcept;

// The pixels that draw_bands() may touch.
Rect band_box(const GlyphRef& ref,
              const Style& style,
              const Placed& placed) noexcept;

// Whether a style's effect, if it has one, draws glyphs of a source.
inline bool can_draw(const Source& source, const Style& style) noexcept {
  const Effect* const effect = style.effect();
  const auto answer = effect == nullptr ? nullptr : effect->mixer().can_draw;
  return answer == nullptr || answer(*effect, style, source.is_field);
}

// Paints the band that the job describes.
void clear_and_fill(GlyphJob& job) noexcept;

}  // namespace inkcell::detail
