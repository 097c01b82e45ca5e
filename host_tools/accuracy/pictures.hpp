// A picture of the worst glyphs: drawn, exact, and the difference.
#pragma once

#include <string_view>
#include <vector>

#include "comparison.hpp"
#include "image.hpp"

namespace inkcell::tools {

/// A glyph to show, and its pixel to mark.
struct Exhibit {
  Picture picture;
  std::string_view filter;
  double px = 0;
  ErrorPlace worst;
};

/// Exhibits below each other: drawn, exact, and eight times their difference,
/// red for too much ink, blue for too little. A frame marks the worst pixel.
/// Captions are written in `font`, if it has the characters.
Image draw_exhibits(const Font& font, const std::vector<Exhibit>& exhibits);

}  // namespace inkcell::tools
