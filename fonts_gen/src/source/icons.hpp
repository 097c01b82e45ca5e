// Makes glyphs with chosen code points from SVG drawings.
#pragma once

#include <string>
#include <vector>

#include "source/font_source.hpp"
#include "source/icon_files.hpp"
#include "source/icon_place.hpp"

namespace inkcell::gen {

/// A font without characters, for icons alone: 1024 units an em, capitals 0.7
/// em high, and a line 1 em high, centred on them.
SourceFont font_for_icons();

/// Adds icons as glyphs to `font` and to its lines; an icon is as wide as its
/// viewBox. Their code points are no longer missing. `has_colours`: drawings of
/// other colours than black alone have layers. Throws Error, also for a code
/// point that the font already has.
void add_icons(const std::vector<IconFile>& icons,
               const IconPlace& place,
               bool has_colours,
               SourceFont& font);

}  // namespace inkcell::gen
