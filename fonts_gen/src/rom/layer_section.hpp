// Layers of glyphs of several colours as the bytes of COLR.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shape/paint.hpp"

namespace inkcell::gen {

/// What a font says of layers; without glyphs: nothing.
struct RomLayers {
  struct Layer {
    size_t glyph = 0;
    size_t colour = 0;
  };
  struct Glyph {
    size_t glyph = 0;
    std::vector<Layer> layers;  // from below
  };
  std::vector<std::vector<Paint>> palettes;  // of one length
  std::vector<Glyph> glyphs;                 // ascending
};

/// The section; empty without glyphs.
std::vector<uint8_t> layers_section(const RomLayers& layers);

}  // namespace inkcell::gen
