// A finished font in pages, read as the device reads it.
#pragma once

#include <cstdint>
#include <vector>

#include "rom/rom_content.hpp"

namespace inkcell::gen {

/// Reads `bytes` with the device's own reader, and compares every character:
/// metrics, record and hints. Throws Error at the first difference.
void check_paged_font(const std::vector<uint8_t>& bytes,
                      const RomContent& content);

}  // namespace inkcell::gen
