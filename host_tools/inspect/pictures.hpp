// Pictures of what is in a font: the cells of a glyph, a sheet of all glyphs.
#pragma once

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

/// All glyphs in the order of their ids at `px` px/em, black on white, each in
/// its own box.
Image draw_sheet(const Font& font, double px);

}  // namespace inkcell::tools
