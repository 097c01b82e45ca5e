// Lines of text as the device shapes them.
#pragma once

#include <string>

#include "inkcell/font.hpp"

namespace inkcell::tools {

/// Prints the glyphs of each line of a file as an array of JSON, from left to
/// right: [{"glyph", "cluster", "x", "y", "advance"}, ...] in font units;
/// clusters count code points. A line is one run of the script and direction of
/// its first letter. Throws std::runtime_error.
void print_runs(const Font& font, const std::string& file);

}  // namespace inkcell::tools
