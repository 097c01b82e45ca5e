// Layers of the glyphs of a font file: tables COLR and CPAL.
#pragma once

#include "source/font_file.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {

/// Sets `painted` of a glyph that has layers of version 0, in the colours of
/// the first palette. Throws Error.
void read_layers(const FontFile& file, SourceGlyph& glyph, Warnings& warnings);

}  // namespace inkcell::gen
