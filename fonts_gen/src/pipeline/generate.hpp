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

/// Generates the font and reads it back with the device's reader. Throws Error.
RomFont generate(const GenerateRequest& request);

}  // namespace inkcell::gen
