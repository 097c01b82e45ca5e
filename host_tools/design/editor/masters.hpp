// Masters of a font, which are layers of its project: the same glyphs in
// another weight or width, whose points correspond.
#pragma once

#include <string>
#include <vector>

#include "editor/editor.hpp"

namespace inkcell::design::editor {

/// The name of a layer; "Default" for UFO's public.default.
std::string master_name(const Project& project, size_t layer);

/// The layer between which and the edited one there are glyphs: the default
/// layer, or if that is edited the first other one that has the glyph. Nothing
/// if there is none.
std::optional<size_t> other_master(const Editor& editor);

/// What does not correspond in two masters of a glyph, one text for each
/// contour or point; empty: there are glyphs between them. `other` is the name
/// of the second master.
std::vector<std::string> mismatches(const Glyph& a,
                                    const Glyph& b,
                                    const std::string& other);

/// The contours and the advance at `part`, 0..1, of the way from a to b, which
/// correspond.
Glyph between(const Glyph& a, const Glyph& b, double part);

}  // namespace inkcell::design::editor
