// Where icons lie beside letters: drawings, and the faces of icons.
#pragma once

#include <string>

namespace inkcell::gen {

struct SourceMetrics;

/// Where the box of an icon lies: the viewBox of a drawing, the em square of a
/// face.
struct IconPlace {
  /// Height of the box: that of capitals, or so many em.
  bool is_cap_high = false;
  double height_em = 1;
  /// The middle of the box is that of capitals, or its lower edge is so many em
  /// above the baseline.
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

/// The box of icons in a font with these metrics. Throws Error if it shall be
/// as high as capitals and the font does not say how high they are.
IconBox icon_box(const IconPlace& place, const SourceMetrics& metrics);

}  // namespace inkcell::gen
