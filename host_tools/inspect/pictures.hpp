// Pictures of what is in a font: cells or points of a glyph, its field, a sheet
// of all glyphs.
#pragma once

#include "census.hpp"
#include "image.hpp"
#include "inkcell/font.hpp"

namespace inkcell::tools {

// The longer side of each picture of one glyph becomes about `side` px. These
// functions throw std::runtime_error if the glyph has no ink, or if the picture
// is not one of the font's coding.

/// The field of a glyph as the device reads it, its edge, and over it the
/// borders of the cells (the paper's figure 2).
Image draw_cells(const Font& font, const GlyphCensus& glyph, int side);

/// The contours of an outline and its points: red squares are corners, green
/// discs are smooth points, blue rings are off the curve. Small green discs are
/// the implied points midway between those. Dashed: the glyph's box. Below them
/// the hints: dashed lines are the zones of the face; lines in red, orange,
/// purple and blue are the edges of bars and serifs, lone edges and free ends;
/// green ones are the edges of stems.
Image draw_points(const FontCensus& census,
                  const Font& font,
                  const GlyphCensus& glyph,
                  int side);

/// The field of a glyph and its edge: of cells where they have one, of outlines
/// 128 u to both sides, as far as the widest filter reaches at 32 px/em.
Image draw_field(const Font& font, const GlyphCensus& glyph, int side);

/// All glyphs in the order of their ids at `px` px/em, black on white, each in
/// its own box.
Image draw_sheet(const Font& font, double px);

}  // namespace inkcell::tools
