// Second masters of a variable font.
#pragma once

#include "base/error.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {

/// Appends a second master of each glyph of `request`'s face that text may
/// show, in the order of the glyphs: the same glyph at the other values of the
/// axes. Glyphs that the axes do not change, icons and glyphs of other faces
/// have none. Throws Error.
void add_masters(const FontRequest& request,
                 SourceFont& font,
                 Warnings& warnings);

}  // namespace inkcell::gen
