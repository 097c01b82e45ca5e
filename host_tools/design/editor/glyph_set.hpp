// Commands that add glyphs, and give them characters and names.
#pragma once

#include <string>

#include "model/project.hpp"

namespace inkcell::design::editor {

/// Adds the characters of a list ("A-Z,0x20-0x7E,U+B0") that no glyph has, or
/// the glyph of one name ("exclam", "_stem"), without contours, at the end of
/// the font's order. Names follow AGLFN. Throws Error if there are none.
Value add_glyphs(const Project& project, const std::string& text);

/// Gives the glyph the characters of a list; none if it is empty.
Value set_characters(const std::string& text);

/// Renames the glyph that is shown.
Value rename_to(const std::string& name);

/// The characters of a glyph as such a list.
std::string character_list(const Glyph& glyph);

}  // namespace inkcell::design::editor
