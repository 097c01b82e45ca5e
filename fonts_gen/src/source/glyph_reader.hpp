// Outlines and measures of a font file.
#pragma once

#include "base/error.hpp"
#include "source/font_file.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {

/// Fills in outline and advance of glyph.source. Throws Error if it cannot be
/// read; warns of an advance that is out of range.
void read_glyph(const FontFile& font, SourceGlyph& glyph, Warnings& warnings);

/// Where hhea has neither ascender nor descender, a line is as high as OS/2
/// says (typographic, else for Windows), or as all glyphs together, with a
/// warning. Heights that the font does not state are those of x and H.
SourceMetrics read_metrics(const FontFile& font, Warnings& warnings);

}  // namespace inkcell::gen
