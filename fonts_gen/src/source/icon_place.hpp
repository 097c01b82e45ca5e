// The position of icons beside letters, for drawings and icon faces.
#pragma once

#include <string>

namespace inkcell::gen {

struct SourceMetrics;

/// The position of an icon's box: the viewBox of a drawing, the em square of a
/// face.
struct IconPlace {
  /// The height of the box: that of capitals, or in em.
  bool is_cap_high = false;
  double height_em = 1;
  /// The middle of the box is at the middle of capitals, or its lower edge is
  /// at this height above the baseline, in em.
  bool is_centred = true;
  double bottom_em = 0;
};

/// Reads "em", "cap" or a number of em. Throws Error.
void parse_icon_height(const std::string& text, IconPlace& place);

/// Reads "middle", "bottom" or a number of em. Throws Error.
void parse_icon_baseline(const std::string& text, IconPlace& place);

/// A box beside the letters of a font. [u], y up
struct IconBox {
  double bottom = 0;
  double height = 0;
};

/// The box of icons in a font with these metrics. Throws Error if the height is
/// that of capitals and the font does not state it.
IconBox icon_box(const IconPlace& place, const SourceMetrics& metrics);

}  // namespace inkcell::gen
