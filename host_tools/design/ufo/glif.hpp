// Glyphs as GLIF, the XML of UFO 3.
#pragma once

#include <string>

#include "model/glyph.hpp"

namespace inkcell::design {

/// `file` is for messages. Throws Error that names it and the glyph.
Glyph parse_glif(const std::string& text, const std::string& file);

/// Equal glyphs give equal texts.
std::string write_glif(const Glyph& glyph);

}  // namespace inkcell::design
