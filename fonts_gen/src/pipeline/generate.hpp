// The generator as one call: from a font file to a ROM font in memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "inkcell/shaped_run.hpp"
#include "pipeline/font_report.hpp"
#include "pipeline/request.hpp"

namespace inkcell::gen {

/// A string that was shaped, with the glyphs of its font.
struct RomString {
  std::string name;
  std::string text;  // UTF-8, in logical order
  std::vector<ShapedGlyph> glyphs;
  int advance = 0;  // [font units]
};

/// A finished font.
struct RomFont {
  std::vector<uint8_t> bytes;
  std::vector<RomString> strings;
  FontReport report;
  Warnings warnings;
};

/// Builds a part of the glyphs of an outline font into request.built_glyphs,
/// which keeps no others. generate() of the same request has that part done
/// then. Throws Error.
void generate_part(const GenerateRequest& request, GlyphPart part);

/// Generates the font and reads it back with the device's reader. Throws Error.
RomFont generate(const GenerateRequest& request);

}  // namespace inkcell::gen
