// Icons: drawings in SVG as glyphs with chosen code points.
#pragma once

#include <string>
#include <vector>

#include "source/font_source.hpp"
#include "source/icon_files.hpp"

namespace inkcell::gen {

/// Where the viewBox of an icon lies beside the letters.
struct IconPlace {
  /// Height of the viewBox: that of capitals, or so many em.
  bool is_cap_high = false;
  double height_em = 1;
  /// The middle of the viewBox is that of capitals, or its lower edge is so
  /// many em above the baseline.
  bool is_centred = true;
  double bottom_em = 0;
};

/// Reads "em", "cap" or a number of em. Throws Error.
void parse_icon_height(const std::string& text, IconPlace& place);

/// Reads "middle", "bottom" or a number of em. Throws Error.
void parse_icon_baseline(const std::string& text, IconPlace& place);

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
