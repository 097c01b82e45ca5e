// Everything that a ROM font says, before it is written.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "field/sample_tree.hpp"
#include "hints/grid_section.hpp"
#include "inkcell/font.hpp"
#include "outlines/minimal_outline.hpp"
#include "rom/layer_section.hpp"
#include "rom/strike_section.hpp"
#include "source/components.hpp"
#include "source/font_source.hpp"
#include "source/kerning.hpp"
#include "target/target.hpp"

namespace inkcell::gen {

/// One glyph as the device sees it: cells, an outline, or no ink.
struct RomGlyph {
  SampleTree field;                     // without tiles: none
  MinimalOutline outline;               // without contours: none
  OutlineReferences references;         // what a record refers to instead
  std::vector<uint8_t> outline_record;  // encode_outlines() makes it
  size_t record_bits = 0;   // of that record, with its zeros at the end
  size_t simple_bytes = 0;  // of the record that the references replace
  GlyphMetrics metrics;

  bool has_ink() const {
    return field.tiles_x != 0 || !outline.contours.empty();
  }
};

/// What the outlines of a font share; without a table: there are none.
struct OutlineCoding {
  int grid_shift = 0;
  int code_bits = 0;
  int max_points = 0;
  size_t most_entries =
      1024;  // of all tables; encode_outlines() may take so many
  std::vector<uint16_t> table;
};

/// A pair of glyphs whose outlines become each other.
struct RomMorph {
  uint16_t first = 0;  // the lesser id
  uint16_t second = 0;
  std::vector<uint8_t> record;
  int points = 0;  // of both glyphs and of the outline between them, at most
};

/// Everything that a ROM font says, before it is written.
struct RomContent {
  std::string name;
  SourceMetrics metrics;
  Target options;
  OutlineCoding outlines;
  std::vector<RomGlyph> glyphs;
  std::map<char32_t, uint16_t> glyph_of;
  KerningMatrix kerning;
  FontHints hints;                   // of outlines only
  std::vector<RomMorph> morphs;      // ascending by first and second
  std::vector<uint8_t> shaping;      // section SHAP; empty: there is none
  std::vector<uint8_t> kept_layout;  // section LAYT; empty: there is none
  std::vector<RomStrike> strikes;
  RomLayers layers;
  size_t first_master = 0;  // of the second masters; 0: there are none
  /// A block of a paged font; 0: it lies in mapped memory. [bytes]
  size_t block_bytes = 0;

  /// The code of the hints: the resident part of a paged font is small.
  HintCode hint_code() const {
    constexpr unsigned kMostOfResident = 3;
    return HintCode(
        hints, block_bytes != 0 ? kMostOfResident : format::grid::kMaxCodeBits);
  }
};

}  // namespace inkcell::gen
