// What is in a font and in a glyph, counted.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "inkcell/font.hpp"

namespace inkcell::tools {

/// Calls `visit` for every leaf of a field, from below, from the left.
void for_each_cell(const GlyphField& field,
                   const std::function<void(const Cell&)>& visit);

/// One glyph.
struct GlyphCensus {
  uint16_t glyph = 0;
  std::vector<char32_t> code_points;
  GlyphMetrics metrics;  // [font units]
  size_t bytes = 0;      // of the record
  GlyphField field;
  int cells = 0;    // with samples
  int outside = 0;  // saturated ones
  int inside = 0;
  int depth = 0;  // steps from a tile to its smallest cell
  /// Cells with samples that are 2^i u wide.
  std::array<int, 12> by_size_log2{};

  /// UTF-8 of its first character, ".notdef" or the id, such as "#17".
  std::string name() const;
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
  FontMetrics metrics;
  FontRange range;
  bool fixed_predicate = false;
  int left_classes = 0;
  int right_classes = 0;
  size_t header_bytes = 0;
  std::vector<SectionCensus> sections;
  std::vector<GlyphCensus> glyphs;
  size_t characters = 0;

  int64_t cells() const;
  int64_t nodes() const;
};

FontCensus take_census(const Font& font);

}  // namespace inkcell::tools
