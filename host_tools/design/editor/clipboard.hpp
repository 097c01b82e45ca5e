// Copies of contours and components, within and between glyphs.
#pragma once

#include <functional>
#include <string>

#include "editor/editor.hpp"

namespace inkcell::design::editor {

/// What is selected, as text: a command for `replay` without a glyph. Contours
/// whose points are selected in part give open ones. All of the glyph if
/// nothing is selected; empty if there is nothing.
std::string copy_of(const Editor& editor);

/// Carries out a text of copy_of() on the glyph that is shown, moved, and
/// selects what it added. Throws Error if it is another text.
void paste(Editor& editor, const std::string& text, double dx, double dy);

}  // namespace inkcell::design::editor
