// Masters of a font, which are layers of its project: the same glyphs in
// another weight or width, whose points correspond.
#pragma once

#include <string>
#include <vector>

#include "editor/editor.hpp"
#include "model/masters.hpp"

namespace inkcell::design::editor {

/// The layer between which and the edited one there are glyphs: the default
/// layer, or if that is edited the first other one that has the glyph. Nothing
/// if there is none.
std::optional<size_t> other_master(const Editor& editor);

/// The contours and the advance at `part`, 0..1, of the way from a to b, which
/// correspond.
Glyph between(const Glyph& a, const Glyph& b, double part);

}  // namespace inkcell::design::editor
