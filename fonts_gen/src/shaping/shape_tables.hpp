// Section SHAP: the programs of scripts, compiled.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "base/byte_writer.hpp"
#include "shaping/layout_table.hpp"
#include "source/shape_script.hpp"

namespace inkcell::gen {

/// What is shaped, in glyphs of the font to be made.
struct ShapeSource {
  const FontFile& file;
  std::vector<ShapePlan> plans;
  GlyphMap glyphs;
  std::map<char32_t, uint16_t> characters;  // of `file` alone
  size_t glyph_count = 0;                   // of the font
  bool kerns_space = false;                 // section KERN has pairs with it
  /// Emoji that are drawings, and drawings of several characters, which are
  /// glyphs of the font here.
  std::map<char32_t, uint16_t> drawings = {};
  std::map<std::vector<uint16_t>, uint16_t> sequences = {};
};

/// The section, which allows most work. Throws Error for what the device cannot
/// do, or if the tables pass a limit of the format.
Bytes shape_section(const ShapeSource& source);

/// The section of a font that shapes no script: what composes the letters of
/// `source`, whose plans and glyphs do not count. Empty if nothing does.
Bytes composing_section(ShapeSource source);

/// Writes how much work a character may take into a section.
void set_shape_steps(Bytes& section, unsigned steps);

}  // namespace inkcell::gen
