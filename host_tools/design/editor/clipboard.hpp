// Copies of contours and components, within and between glyphs.
#pragma once

#include <functional>
#include <string>

#include "editor/editor.hpp"

namespace inkcell::design::editor {

/// The selection as text: a command for `replay` without a glyph. Contours with
/// partly selected points become open ones. The whole glyph if nothing is
/// selected; empty if there is nothing.
std::string copy_of(const Editor& editor);

/// Runs a text of copy_of() on the shown glyph, moved, and selects what was
/// added. Throws Error for any other text.
void paste(Editor& editor, const std::string& text, double dx, double dy);

}  // namespace inkcell::design::editor
