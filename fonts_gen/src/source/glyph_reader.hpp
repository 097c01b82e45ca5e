// Reads outlines and metrics of a font file.
#pragma once

#include "base/error.hpp"
#include "source/font_file.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {

/// Sets outline and advance of glyph.source. Throws Error if it cannot be read;
/// warns if the advance is out of range.
void read_glyph(const FontFile& font, SourceGlyph& glyph, Warnings& warnings);

/// If hhea has neither ascender nor descender, those of OS/2 are used
/// (typographic, else for Windows), or with a warning the height of all glyphs.
/// Missing heights are measured from x and H.
SourceMetrics read_metrics(const FontFile& font, Warnings& warnings);

}  // namespace inkcell::gen
