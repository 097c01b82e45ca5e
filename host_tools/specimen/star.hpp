// A test pattern as in figure 9 of the paper: wedges that get finer than pixels
// towards the middle.
#pragma once

#include "image.hpp"
#include "inkcell/font.hpp"

namespace inkcell::tools {

/// Supersampled, with one sample a pixel, and with up to 13; the middles are
/// enlarged below. Labels are written in `font`.
Image draw_star(const Font& font);

}  // namespace inkcell::tools
