// A picture of a finished font: every glyph, its bytes and its error.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/generate.hpp"

namespace inkcell::gen {

/// Black on white, 8 bits a pixel, rows from the top.
struct Preview {
  int width = 0;  // [px]
  int height = 0;
  std::vector<uint8_t> pixels;
};

/// Draws all glyphs by the device's code, at 48 px or the font's largest size
/// if that is smaller. Below each stand the bytes of its record and its worst
/// error against the outline it was made of [1/255; fixed predicate: 1/1024
/// em]. Throws Error if the device cannot read the font.
Preview draw_preview(const RomFont& font);

}  // namespace inkcell::gen
