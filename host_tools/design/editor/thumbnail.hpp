// Small pictures of glyphs, from their exact distance.
#pragma once

#include "image.hpp"
#include "model/project.hpp"

namespace inkcell::design::editor {

/// Ink of a glyph, 0..255, in a square of `side` px: an em is 0.62 of it, the
/// advance is centred. Empty where the glyph has no ink, or cannot be drawn.
tools::Image thumbnail(const Project& project, const Glyph& glyph, int side);

}  // namespace inkcell::design::editor
