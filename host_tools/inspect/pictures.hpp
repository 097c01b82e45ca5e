// Pictures of what is in a font: the cells of a glyph, its edges, a sheet of
// all glyphs.
#pragma once

#include "census.hpp"
#include "image.hpp"
#include "inkcell/font.hpp"

namespace inkcell::tools {

/// The field of a glyph as the device reads it, its edge, and over it the
/// borders of the cells (the paper's figure 2): green, blue and red around
/// cells of one, two and three fields, dark around samples. In cells of several
/// fields thin lines show where one of them is zero. The longer side of the
/// glyph's grid becomes about `side` px.
///
/// Throws std::runtime_error if the glyph has no ink.
Image draw_cells(const GlyphField& field, int side);

/// The same field, and over it what grid fitting knows: dashed lines at the
/// font's zones, red ones at edges below a bar, purple ones at the glyph's
/// other edges, green ones in the middle of its stems.
Image draw_edges(const FontCensus& font, const GlyphCensus& glyph, int side);

/// All glyphs in the order of their ids at `px` px/em, black on white, each in
/// its own box.
Image draw_sheet(const Font& font, double px);

}  // namespace inkcell::tools
