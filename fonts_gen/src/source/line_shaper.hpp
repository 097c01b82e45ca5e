// Lines of text as glyphs: ordered by FriBidi, shaped by HarfBuzz.
#pragma once

#include <cstdint>
#include <vector>

#include "source/font_file.hpp"
#include "source/line_text.hpp"

namespace inkcell::gen {

/// A glyph of a line. Font units, y up, from the line's origin.
struct LineGlyph {
  uint32_t source = 0;  // id in the font file
  int x = 0;
  int y = 0;
};

/// A shaped line.
struct ShapedLine {
  std::vector<LineGlyph> glyphs;  // left to right, only those with ink
  int advance = 0;                // [font units]
  /// Characters that the font lacks, in ascending order: .notdef stands there.
  std::vector<char32_t> missing;
};

/// Shapes a line with the font's default features: ligatures, joined letters,
/// syllables, marks and kerning. Directions and order are those of UAX #9.
/// Characters that show nothing have no glyph. Throws Error if FriBidi fails.
ShapedLine shape_line(const FontFile& font, const LineText& line);

}  // namespace inkcell::gen
