// Glyphs of several colours: layers that become glyphs, and a form of one
// colour.
#pragma once

#include "rom/rom_content.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {

/// Adds the layers of all glyphs at the end of a font, equal ones once, and
/// gives each glyph that has layers its form of one colour. Throws Error that
/// names the glyph.
void make_layers(SourceFont& font, int threads);

/// What the finished font says of layers.
RomLayers rom_layers(const SourceFont& font);

}  // namespace inkcell::gen
