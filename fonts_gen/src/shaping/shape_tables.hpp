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
};

/// The section, which allows most work. Throws Error for what the device cannot
/// do, or if the tables pass a limit of the format.
Bytes shape_section(const ShapeSource& source);

/// Writes how much work a character may take into a section.
void set_shape_steps(Bytes& section, unsigned steps);

}  // namespace inkcell::gen
