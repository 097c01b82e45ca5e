// The container: from fields and tables to the bytes that lie in ROM.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rom/rom_content.hpp"

namespace inkcell::gen {

/// Bytes of each part with its padding; they add up to the whole font.
struct PartBytes {
  size_t header = 0;  // with the section directory
  size_t cmap = 0;
  size_t metrics = 0;
  size_t kerning = 0;
  size_t hints = 0;  // also those at the end of records
  size_t morphs = 0;
  size_t shaping = 0;
  size_t strikes = 0;
  size_t layers = 0;  // lists and palettes, without their outlines
  size_t glyphs = 0;  // records and offsets; of outlines the code table, too
  size_t name = 0;

  size_t total() const {
    return header + cmap + metrics + kerning + hints + morphs + shaping +
           strikes + layers + glyphs + name;
  }
};

/// The font's bytes as docs/FORMAT.md states them. They depend on `content`
/// only. `parts` is filled in. Throws Error if the font passes a limit of the
/// format.
std::vector<uint8_t> write_rom_font(const RomContent& content,
                                    PartBytes& parts);

/// The record of a glyph, without padding and hints. Empty for a glyph without
/// ink.
///
/// Throws GeometryError::too_complex if it does not fit the format.
std::vector<uint8_t> glyph_record(const RomGlyph& glyph);

/// The same with the hints that the font has for glyph `i`.
std::vector<uint8_t> hinted_record(const RomContent& content,
                                   size_t i,
                                   const HintCode& code);

}  // namespace inkcell::gen
