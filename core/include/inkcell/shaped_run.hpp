// Lines of text that were shaped and ordered when the program was built.
//
// Ligatures, joined Arabic letters, Indic syllables and placed marks need a
// shaper, which runs in the generator: `inkcell-fontgen --strings` makes runs
// of glyphs, in ROM beside their font (docs/STRINGS.md).
//
//   painter.text(font, style, origin, fonts::ui_strings::title);
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"

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

/// Positions of all glyphs of a run as designed, for Painter::glyphs() and
/// others. Offsets are 0, as is the face. Positions are clamped to +-2^24 font
/// units.
///
/// buffer_small: `out` has less than run.glyphs.size; `glyphs` is untouched.
Status lay_out(const ShapedRun& run,
               Span<PositionedGlyph> out,
               Span<const PositionedGlyph>& glyphs) noexcept;

/// Width and ink of a run as designed in font units, y up, from its origin.
TextMeasure measure(const Font& font, const ShapedRun& run) noexcept;

}  // namespace inkcell
