// Layers of the glyphs of a font file: tables COLR and CPAL.
#pragma once

#include "source/font_file.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {

/// Whether a glyph has layers of version 0, or paints of version 1.
bool has_layers(const FontFile& file, uint32_t glyph);

/// Sets `painted` of a glyph that has them, in the colours of the first
/// palette: layers of version 0 if there are any, which are flat, else paints.
/// Each glyph of these is a layer, moved as they say. Gradients become their
/// mean; returns how many there were. Throws Error where layers in one colour
/// each are not the same: other composites than one over the other, glyphs
/// that bound more than a fill, and paints in a circle.
size_t read_layers(const FontFile& file,
                   SourceGlyph& glyph,
                   Warnings& warnings);

}  // namespace inkcell::gen
