// The generator as one call: from a font file to a ROM font in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "adf.hpp"
#include "closed_loop.hpp"
#include "error.hpp"
#include "font_file.hpp"
#include "rom_font.hpp"

namespace inkcell::gen {

/// What to generate. The defaults are those of the command line.
struct GenerateRequest {
  std::filesystem::path font;
  int face = 0;
  std::vector<AxisSetting> axes;
  /// Characters: the union of all three; printable ASCII if all are empty.
  std::vector<std::string> chars;  // lists as add_ranges reads them
  std::vector<std::filesystem::path> text_files;
  std::string symbols;  // UTF-8
  /// Sizes are whole numbers within 4..1024 px/em, min <= max; the tolerance is
  /// a whole number within 1..255.
  AdfOptions adf;
  GenerateRequest() { adf.coding = Coding::outline; }
  /// Whether an outline font says what grid fitting needs.
  bool hints = true;
  /// Threads; 0: all cores. The bytes do not depend on it.
  int jobs = 0;
  /// Called now and then on the calling thread with glyphs done and their
  /// number.
  std::function<void(size_t done, size_t count)> progress;
};

/// What became of one glyph.
struct GlyphReport {
  std::string name;  // U+0041 'A'
  std::string key;   // its smallest character in UTF-8, or .notdef
  size_t cells = 0;  // that are not saturated
  size_t nodes = 0;
  size_t fields = 0;  // distinct ones, of cells of fields
  size_t points = 0;  // of outlines; on and off curve, implied ones not counted
  size_t components = 0;  // that a composite record refers to; 0: simple
  size_t bytes = 0;       // of its record
  /// size_aware: of the pixels that the device draws, at the worst size; the
  /// mean over the ink's box and 1.5 px [1/255]. fixed: as AdfGlyph.
  double worst_error = 0;
  double mean_error = 0;
  int worst_px = 0;  // size_aware: the size of the worst pixel
  bool within_tolerance = true;
};

/// Cells that are not saturated, by what they hold.
struct CellCounts {
  size_t samples = 0;
  size_t single = 0;  // fields
  size_t pairs = 0;
  size_t triples = 0;
};

struct FontReport {
  std::string file_name;
  std::string name;  // family and style
  AdfOptions options;
  PartBytes bytes;
  std::vector<GlyphReport> glyphs;
  std::vector<char32_t> missing;
  size_t characters = 0;
  int left_classes = 0;
  int right_classes = 0;
  size_t cells = 0;
  size_t nodes = 0;
  CellCounts kinds;
  size_t fields = 0;
  size_t points = 0;      // of all records of outlines
  size_t composites = 0;  // glyphs that refer to others
  /// size_aware: as drawn, of all glyphs together; the mean of a size is that
  /// of the glyphs' means.
  std::vector<SizeError> sizes;
  double worst_error = 0;  // of all glyphs
  double mean_error = 0;   // at the worst size; fixed: over the glyphs with ink
  double seconds = 0;
  /// What AdfOptions::band_px cost, if it was asked for and measured. [bytes]
  std::optional<int64_t> band_bytes;

  /// Of the same cells as a list of leaves, the paper's form: 15 bytes each.
  size_t leaf_list_bytes() const { return 15 * cells; }
};

/// A finished font.
struct RomFont {
  std::vector<uint8_t> bytes;
  FontReport report;
  Warnings warnings;
};

/// Generates the font and reads it back with the device's reader. Throws Error.
RomFont generate(const GenerateRequest& request);

}  // namespace inkcell::gen
