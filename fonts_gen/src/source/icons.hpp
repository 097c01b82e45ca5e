// Icons: drawings in SVG as glyphs with chosen code points.
#pragma once

#include <string>
#include <vector>

#include "source/font_source.hpp"
#include "source/icon_files.hpp"
#include "source/icon_place.hpp"

namespace inkcell::gen {

/// A font without characters, for icons alone: an em is 1024 units, capitals
/// are 0.7 em high, and a line is 1 em high around their middle.
SourceFont font_for_icons();

/// Adds icons as glyphs to `font` and to its lines; an icon is as wide as its
/// viewBox. Their code points are missing no longer. Throws Error, also for a
/// code point that the font has already.
void add_icons(const std::vector<IconFile>& icons,
               const IconPlace& place,
               SourceFont& font);

}  // namespace inkcell::gen
