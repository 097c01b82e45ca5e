// The container: from fields and tables to the bytes that lie in ROM.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "adf.hpp"
#include "alignment.hpp"
#include "field_tree.hpp"
#include "font_source.hpp"
#include "inkcell/font.hpp"
#include "kerning.hpp"

namespace inkcell::gen {

/// One glyph as the device sees it: cells of one kind, or no ink.
struct RomGlyph {
  AdfGlyph samples;  // without tiles: none
  FieldTree fields;  // without tiles: none
  GlyphMetrics metrics;

  bool has_ink() const {
    return samples.tiles_x != 0 || fields.grid.tiles_x != 0;
  }
};

/// Everything that a ROM font says, before it is written.
struct RomContent {
  std::string name;
  SourceMetrics metrics;
  AdfOptions options;
  std::vector<RomGlyph> glyphs;
  std::map<char32_t, uint16_t> glyph_of;
  KerningMatrix kerning;
  Alignment alignment;
};

/// Bytes of each part with its padding; they add up to the whole font.
struct PartBytes {
  size_t header = 0;  // with the section directory
  size_t cmap = 0;
  size_t metrics = 0;
  size_t kerning = 0;
  size_t hints = 0;
  size_t cells = 0;  // with the glyph records' headers, references and offsets
  size_t name = 0;

  size_t total() const {
    return header + cmap + metrics + kerning + hints + cells + name;
  }
};

/// The font's bytes as docs/FORMAT.md states them. They depend on `content`
/// only. `parts` is filled in. Throws Error if the font passes a limit of the
/// format.
std::vector<uint8_t> write_rom_font(const RomContent& content,
                                    PartBytes& parts);

/// Reads `bytes` with the device's own reader and compares all that it says
/// with `content`: header, every character, metric, pair of kerning classes and
/// cell. Throws Error at the first difference.
void check_rom_font(const std::vector<uint8_t>& bytes,
                    const RomContent& content);

/// The record of a glyph, without padding. Empty for a glyph without ink.
///
/// Throws GeometryError::too_complex if it does not fit the format.
std::vector<uint8_t> glyph_record(const RomGlyph& glyph);

}  // namespace inkcell::gen
