// The content of a font and of a glyph, counted.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "grid_hints.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "inkcell/font.hpp"
#include "outline_points.hpp"

namespace inkcell::tools {

/// Bytes of a part of a record.
struct RecordPart {
  std::string name;
  size_t bytes = 0;
};

/// Adds parts to those of the same name.
void add_parts(const std::vector<RecordPart>& parts,
               std::vector<RecordPart>& sum);

/// One glyph.
struct GlyphCensus {
  uint16_t glyph = 0;
  GlyphField field;      // empty if the glyph has no cells
  GlyphOutline outline;  // empty if it has no outline
  std::vector<char32_t> code_points;
  GlyphMetrics metrics;  // [font units]
  size_t bytes = 0;      // of the record
  std::vector<RecordPart> parts;
  int cells = 0;  // that are not saturated
  int nodes = 0;
  int outside = 0;  // saturated cells
  int inside = 0;
  int depth = 0;  // steps from a tile to its smallest cell
  /// Cells that are not saturated and 2^i u wide.
  std::array<int, 12> by_size_log2{};

  /// UTF-8 of its first character, ".notdef" or the id, such as "#17".
  std::string name() const;
  bool has_ink() const { return cells > 0 || outline.points() > 0; }
};

/// A section of the file.
struct SectionCensus {
  std::string tag;
  uint32_t offset = 0;  // [bytes]
  uint32_t size = 0;    // [bytes]
  bool must_understand = false;
};

/// A whole font.
struct FontCensus {
  std::string name;
  size_t bytes = 0;
  int format_major = 0;
  int format_minor = 0;
  Status verified = Status::ok;
  std::string coding_name;
  FontMetrics metrics;
  FontRange range;
  bool fixed_predicate = false;
  int morph_pairs = 0;
  int masters = 0;                    // glyphs that are second masters
  std::vector<std::string> strikes;   // "12 px, 1 bits, 96 glyphs, fit 2"
  int layer_lists = 0;                // glyphs of several colours
  std::vector<std::string> palettes;  // "#ffcc4d #ff000080"
  int left_classes = 0;
  int right_classes = 0;
  size_t header_bytes = 0;
  std::vector<SectionCensus> sections;
  GridHints hints;
  std::vector<GlyphCensus> glyphs;
  size_t characters = 0;
  // For outlines only; empty for other fonts.
  std::vector<CodeWord> words;
  double grid_units = 1;
  int max_points = 0;

  int64_t cells() const;
  int64_t nodes() const;
  std::vector<RecordPart> parts() const;  // of all records
  bool has_outlines() const { return !words.empty(); }
  // Without composites.
  int64_t points() const;
  int64_t points_of(PointKind kind) const;
  int composites() const;
  int64_t uses(size_t word) const;
};

FontCensus take_census(const Font& font);

}  // namespace inkcell::tools
