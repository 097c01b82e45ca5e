// Specimen pictures of a font: sizes, angles, paragraphs, digits.
#pragma once

#include "image.hpp"
#include "inkcell/font.hpp"

namespace inkcell::tools {

/// One line at sizes from 8 to 60 px, and a word in many directions; the
/// picture is `width` px wide. Black on white, as all of these.
Image draw_sizes(const Font& font, int width);

/// Paragraphs at 11, 13 and 16 px.
Image draw_body(const Font& font);

/// A clock that fills a panel. The font only needs digits and a colon.
Image draw_digits(const Font& font);

/// A word in many directions around a point.
Image draw_turned(const Font& font);

/// A line that moves right by 1/8 px from row to row.
Image draw_moved(const Font& font);

}  // namespace inkcell::tools
