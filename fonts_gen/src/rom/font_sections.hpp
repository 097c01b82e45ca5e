// The sections of fonts, which write_rom_font() and write_paged_font() share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rom/rom_content.hpp"
#include "rom/rom_font.hpp"

namespace inkcell::gen {

struct FontSection {
  uint32_t tag;
  uint32_t must_understand;  // kMustUnderstand or 0
  std::vector<uint8_t> bytes;
  size_t PartBytes::*part;
};

/// CRC-32 as docs/FORMAT.md states it, after bytes whose sum is `crc`.
uint32_t crc32(const uint8_t* data, size_t size, uint32_t crc = 0);

std::vector<uint8_t> metrics_section(const RomContent& content);
std::vector<uint8_t> kerning_section(const RomContent& content);
/// GLYF, of the content's coding.
std::vector<uint8_t> glyphs_section(const RomContent& content,
                                    const HintCode& code);
std::vector<uint8_t> code_section(const RomContent& content);

/// A font of these sections. Measures of all glyphs are those of `content`.
std::vector<uint8_t> assemble_font(const RomContent& content,
                                   size_t glyph_count,
                                   const std::vector<FontSection>& sections,
                                   PartBytes& parts);

}  // namespace inkcell::gen
