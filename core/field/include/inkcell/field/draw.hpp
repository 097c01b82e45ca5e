// Fields on the screen: fonts of fields, and fields of single glyphs.
//
//   Font font;
//   INKCELL_TRY(Font::open(rom, kFieldCoding, font));
//   Painter(sink).text(font, style, origin, "Hello");
//
// A field fills the same bands as outlines do, so that all filters and effects
// draw both. Pixel (i, j) covers [i, i + 1] x [j, j + 1], x to the right, y
// down; its distance is sampled at its centre. A style that stretches edges
// differently takes the direction of an edge from the field's gradient.
#pragma once

#include <stdint.h>

#include "inkcell/coding.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "inkcell/workspace.hpp"

namespace inkcell {

/// The coding of fonts that inkcell-fontgen makes with --coding field.
extern const Coding kFieldCoding;

/// Font::open() of a font of outlines or of fields, by its header: for programs
/// whose fonts are not known when they are compiled. Links what draws both.
inline Status open_any_font(Span<const uint8_t> rom, Font& out) noexcept {
  const Status status = Font::open(rom, out);
  return status == Status::unsupported ? Font::open(rom, kFieldCoding, out)
                                       : status;
}

/// Draws the glyph whose origin (left end of its baseline) is at `origin`, into
/// `sink`. Clipped to the sink's window; cannot fail. The picture does not
/// depend on how a screen is cut into windows, nor on the workspace.
void draw_field(const GlyphField& field,
                const Style& style,
                FinePoint origin,
                const Sink& sink,
                Workspace workspace = {}) noexcept;

/// The pixels that draw_field may touch, before clipping: those in the glyph's
/// grid and no farther from its ink than the style reaches (for slanted text,
/// in the box around that).
Rect field_box(const GlyphField& field,
               const Style& style,
               FinePoint origin) noexcept;

/// Signed distances, in px, at the centres of `out.size` pixels of row `y` from
/// `x` to the right, x + out.size below 2^31. Saturated ones are one em or 32
/// px, whichever is less; 32 px where a matrix stretches the glyph. For filters
/// and effects of one's own: draw_field rounds them to 1/127 of the reach of
/// the style.
void distance_row(const GlyphField& field,
                  const Style& style,
                  FinePoint origin,
                  int32_t x,
                  int32_t y,
                  Span<Q6_10> out) noexcept;

}  // namespace inkcell
