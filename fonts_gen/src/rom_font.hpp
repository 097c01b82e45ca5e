// The container: from fields and tables to the bytes that lie in ROM.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "adf.hpp"
#include "field_tree.hpp"
#include "font_source.hpp"
#include "hints/glyph_hints.hpp"
#include "inkcell/font.hpp"
#include "kerning.hpp"
#include "outlines/minimal_outline.hpp"
#include "outlines/outline_record.hpp"

namespace inkcell::gen {

/// One glyph as the device sees it: cells of one kind, an outline, or no ink.
struct RomGlyph {
  AdfGlyph samples;                     // without tiles: none
  FieldTree fields;                     // without tiles: none
  MinimalOutline outline;               // without contours: none
  OutlineReferences references;         // what a record refers to instead
  std::vector<uint8_t> outline_record;  // encode_outlines() makes it
  GlyphMetrics metrics;

  bool has_ink() const {
    return samples.tiles_x != 0 || fields.grid.tiles_x != 0 ||
           !outline.contours.empty();
  }
};

/// What the outlines of a font share; without a table: there are none.
struct OutlineCoding {
  int grid_shift = 0;
  int code_bits = 0;
  int max_points = 0;
  std::vector<uint16_t> table;
};

/// Everything that a ROM font says, before it is written.
struct RomContent {
  std::string name;
  SourceMetrics metrics;
  AdfOptions options;
  OutlineCoding outlines;
  std::vector<RomGlyph> glyphs;
  std::map<char32_t, uint16_t> glyph_of;
  KerningMatrix kerning;
  FontHints hints;  // of outlines only
};

/// Bytes of each part with its padding; they add up to the whole font.
struct PartBytes {
  size_t header = 0;  // with the section directory
  size_t cmap = 0;
  size_t metrics = 0;
  size_t kerning = 0;
  size_t hints = 0;
  size_t glyphs = 0;  // records and offsets; of outlines the code table, too
  size_t name = 0;

  size_t total() const {
    return header + cmap + metrics + kerning + hints + glyphs + name;
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
