// A finished font, read as the device reads it.
#pragma once

#include <cstdint>
#include <vector>

#include "rom/rom_content.hpp"

namespace inkcell::gen {

/// Reads `bytes` with the device's own reader and compares all that it says
/// with `content`: header, every character, metric, pair of kerning classes and
/// cell. Throws Error at the first difference.
void check_rom_font(const std::vector<uint8_t>& bytes,
                    const RomContent& content);

/// The same for a font in pages: every character's metrics, record and hints,
/// and the kerning.
void check_paged_font(const std::vector<uint8_t>& bytes,
                      const RomContent& content);

}  // namespace inkcell::gen
