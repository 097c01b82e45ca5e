// The exact area of each pixel, piece by piece of the border.
#pragma once

#include <vector>

#include "truth.hpp"

namespace inkcell::tools {

/// The shares of the pixels of a picture, row by row, that a border encloses,
/// 0..1. The pieces are in pixels, y down, and within the picture; the area
/// lies to the right of those that go up. Shares no code with the generator.
std::vector<double> pixel_areas(const std::vector<TrueGlyph::Chord>& border,
                                int width,
                                int height);

}  // namespace inkcell::tools
