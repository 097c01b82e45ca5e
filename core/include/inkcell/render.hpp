// From a glyph's field to coverage: the scanline renderer.
//
// One distance sample per pixel, taken at the pixel's centre, and mapped to
// coverage by the style's filter (Perry and Frisken, section 4.2.2). Pixel
// (i, j) covers [i, i + 1] x [j, j + 1], x to the right, y down.
#pragma once

#include <stdint.h>

#include "inkcell/field.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text_style.hpp"

namespace inkcell {

/// Draws the glyph whose origin (left end of its baseline) is at `origin`, into
/// `sink`. Clipped to the sink's window; cannot fail. The picture does not
/// depend on how a screen is cut into windows, if the field keeps the limits of
/// docs/FORMAT.md; else it has no meaning, but stays in the window.
void draw_field(const GlyphField& field,
                const TextStyle& style,
                FinePoint origin,
                const Sink& sink) noexcept;

/// The pixels that draw_field may touch, before clipping: those whose centres
/// lie in the glyph's grid and no farther from its ink than the filter reaches
/// (for slanted text, in the box around that).
Rect field_box(const GlyphField& field,
               const TextStyle& style,
               FinePoint origin) noexcept;

/// Signed distances, in px, at the centres of `out.size` pixels of row `y` from
/// `x` to the right, x + out.size below 2^31. Saturated ones are one em or 32
/// px, whichever is less; 32 px where a matrix stretches cells of primitives.
/// The plain form of what draw_field fuses, for filters and effects of one's
/// own: style.filter() maps these distances to the coverage that draw_field
/// draws, bit by bit, without an effect.
void distance_row(const GlyphField& field,
                  const TextStyle& style,
                  FinePoint origin,
                  int32_t x,
                  int32_t y,
                  Span<Q6_10> out) noexcept;

}  // namespace inkcell
