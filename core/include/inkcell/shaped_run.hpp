// Lines of text that were shaped and ordered when the program was built.
//
// Ligatures, joined Arabic letters, Indic syllables and placed marks need a
// shaper, which runs in the generator: `inkcell-fontgen --strings` makes runs
// of glyphs, in ROM beside their font (docs/STRINGS.md).
//
//   painter.text(font, style, origin, fonts::ui_strings::title);
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"

namespace inkcell {

/// A glyph of a shaped run. Font units, y up.
struct ShapedGlyph {
  uint16_t glyph = 0;  // id in the font that was made with the run
  int16_t x = 0;       // from the glyph before it; from the run's origin first
  int16_t y = 0;       // from the baseline
};

/// A line of glyphs from left to right, without those that show nothing. Any
/// numbers are safe: glyphs that the font lacks are left out.
struct ShapedRun {
  Span<const ShapedGlyph> glyphs;
  int32_t advance = 0;  // [font units]; to_px() gives px
};

}  // namespace inkcell
