// The generator as one call: from a font file to a ROM font in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "base/error.hpp"
#include "pipeline/font_report.hpp"
#include "pipeline/request.hpp"

namespace inkcell::gen {

/// A finished font.
struct RomFont {
  std::vector<uint8_t> bytes;
  FontReport report;
  Warnings warnings;
};

/// Generates the font and reads it back with the device's reader. Throws Error.
RomFont generate(const GenerateRequest& request);

}  // namespace inkcell::gen
