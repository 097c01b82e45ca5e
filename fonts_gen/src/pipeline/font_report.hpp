// What became of a font: bytes, cells, points and errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "judge/closed_loop.hpp"
#include "pipeline/request.hpp"
#include "rom/rom_content.hpp"
#include "rom/rom_font.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {

/// What became of one glyph.
struct GlyphReport {
  std::string name;       // U+0041 'A'
  std::string file_name;  // the font or drawing it comes from
  std::string key;        // its smallest character in UTF-8, or .notdef
  size_t cells = 0;       // that are not saturated
  size_t nodes = 0;
  size_t points = 0;  // of outlines; on and off curve, implied ones not counted
  size_t bytes = 0;   // of its record
  /// size_aware: what GlyphErrors promises; the mean over the ink's box and 1.5
  /// px at the worst size [1/255]. fixed: as SampleTree.
  double worst_error = 0;
  double mean_error = 0;
  int worst_px = 0;      // size_aware: the size of the worst pixel
  double worst_x_u = 0;  // its centre in the glyph
  double worst_y_u = 0;
  bool within_tolerance = true;
  double distance_error = 0;  // size_aware: with the filter `text` [1/255]
};

/// What the characters of a language cost.
struct LanguageReport {
  std::string language;
  CharSet characters;      // that its translations show
  size_t missing = 0;      // of them, not in the font
  size_t bytes = 0;        // of the records of their glyphs
  size_t bytes_alone = 0;  // of those that nothing else asks for
};

struct FontReport {
  std::string file_name;
  std::string name;  // family and style
  Target options;
  PartBytes bytes;
  std::vector<GlyphReport> glyphs;
  std::vector<char32_t> missing;
  std::vector<char32_t> added;  // that layout may need
  size_t added_bytes = 0;       // of their records
  std::vector<LanguageReport> languages;
  std::vector<IconFile> icons;
  std::vector<SourceFace> faces;
  std::vector<StrikeTarget> strikes;
  size_t layer_lists = 0;     // glyphs of several colours
  size_t layer_outlines = 0;  // that they share
  size_t colours = 0;         // of a palette
  size_t characters = 0;
  size_t masters = 0;       // glyphs that are second masters
  size_t master_bytes = 0;  // of their records
  int left_classes = 0;
  int right_classes = 0;
  size_t cells = 0;
  size_t nodes = 0;
  size_t points = 0;           // of all records of outlines
  size_t composites = 0;       // glyphs that refer to others
  size_t composite_bytes = 0;  // their records
  size_t simple_bytes = 0;     // records of their outlines instead
  /// size_aware: as drawn with the default filter, of all glyphs together; the
  /// mean of a size is that of the glyphs' means.
  std::vector<SizeError> sizes;
  double worst_error = 0;  // of all glyphs
  double mean_error = 0;   // at the worst size; fixed: over the glyphs with ink
  double distance_error = 0;  // size_aware: likewise, with the filter `text`
  double distance_mean = 0;
  double seconds = 0;
  /// What Target::band_px cost, if it was asked for and measured. [bytes]
  std::optional<int64_t> band_bytes;

  /// The same cells as a list of leaves, the paper's form: 15 bytes each.
  size_t leaf_list_bytes() const { return 15 * cells; }
};

/// `errors`: of each glyph as drawn.
FontReport make_report(const SourceFont& font,
                       const RomContent& content,
                       const std::vector<GlyphErrors>& errors);

/// What each language of the translations costs in the font of `report`.
std::vector<LanguageReport> report_languages(const SourceFont& font,
                                             const AskedCharacters& asked,
                                             const FontReport& report);

/// Names the glyphs that miss the tolerance: throws Error if that is a limit,
/// else adds a warning. The fixed predicate, which corners miss, only warns.
void tell_of_errors(const FontReport& report,
                    bool tolerance_is_limit,
                    Warnings& warnings);

}  // namespace inkcell::gen
