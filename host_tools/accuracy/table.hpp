// The errors of all glyphs, as a table and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "comparison.hpp"
#include "errors.hpp"
#include "rom_file.hpp"

namespace inkcell::tools {

/// What was compared, and the errors.
struct ErrorTable {
  ComparisonRequest request;
  std::vector<Mapping> characters;
  std::vector<std::vector<GlyphErrors>> errors;  // from compare_glyph()

  ErrorSummary summary(size_t size, size_t filter) const;
  /// The errors of all sizes together.
  ErrorSummary total(size_t filter) const;
};

/// A glyph's worst pixel.
struct WorstOfGlyph {
  size_t character = 0;  // in ErrorTable::characters
  size_t size = 0;       // in the request, likewise
  size_t filter = 0;
  ErrorPlace place;
};

/// The worst pixels of the `count` worst glyphs, the worst one first.
std::vector<WorstOfGlyph> worst_glyphs(const ErrorTable& table, size_t count);

/// A row for each size and filter, and one for all sizes, to standard output.
void print_table(const ErrorTable& table);

/// The same rows; those for all sizes without "px".
nlohmann::json table_as_json(const ErrorTable& table);

}  // namespace inkcell::tools
