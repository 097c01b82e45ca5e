// Shapes lines of text with one face or several: FriBidi orders them, HarfBuzz
// shapes them.
#pragma once

#include <cstdint>
#include <vector>

#include "source/font_file.hpp"
#include "source/line_text.hpp"

namespace inkcell::gen {

/// The pseudo-face of icons, whose ids are code points.
inline constexpr size_t kIconFace = SIZE_MAX;

/// A glyph of a line. [font units of the first face, y up, from the line's
/// origin]
struct LineGlyph {
  size_t face = 0;      // 0 for .notdef
  uint32_t source = 0;  // id in the file of the face
  int x = 0;
  int y = 0;
  /// Only for .notdef: the character that is missing, and the advance.
  char32_t lacking = 0;
  int advance = 0;
};

/// A shaped line.
struct ShapedLine {
  std::vector<LineGlyph> glyphs;  // left to right: .notdef, and all with ink
  int advance = 0;                // [font units of the first face]
  /// Characters that all faces lack, in ascending order; shown as .notdef.
  std::vector<char32_t> missing;
};

/// A face; its em is `scale` em of the first one.
struct ShapingFace {
  ShapingFace(const FontFile* from, double em = 1) : file(from), scale(em) {}

  const FontFile* file;
  double scale;
};

/// Shapes a line with the default features of its faces: ligatures, joined
/// letters, syllables, marks and kerning. Directions and order follow UAX #9. A
/// letter with its marks comes from the first face that has all of them, else
/// from the first that has the letter. Invisible characters have no glyph.
///
/// There is at least one face. Throws Error if FriBidi fails.
ShapedLine shape_line(const std::vector<ShapingFace>& faces,
                      const LineText& line);

/// Puts an icon with this advance [font units of the first face] where
/// `code_point` was missing. Glyphs to its right move.
void place_icon(char32_t code_point, int advance, ShapedLine& line);

}  // namespace inkcell::gen
