// A picture of the worst glyphs: what is drawn, what should be, and by how much
// they differ.
#pragma once

#include <string_view>
#include <vector>

#include "comparison.hpp"
#include "image.hpp"

namespace inkcell::tools {

/// A glyph to show, and the pixel to mark in it.
struct Exhibit {
  Picture picture;
  std::string_view filter;
  double px = 0;
  ErrorPlace worst;
};

/// Exhibits below each other: drawn, exact, and their difference eight times as
/// strong, red where there is too much ink, blue where there is too little. A
/// frame marks the worst pixel. Captions are written in `font`, if it has the
/// characters.
Image draw_exhibits(const Font& font, const std::vector<Exhibit>& exhibits);

}  // namespace inkcell::tools
