// Sections CMAP and CPAG (docs/FORMAT.md): from code points to glyphs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace inkcell::gen {

/// Code points in runs, consecutive ones on consecutive glyphs. Short runs
/// whose glyphs follow each other, as those of hanzi, go to the pages of CPAG
/// where that takes fewer bytes.
class CharacterRuns {
 public:
  explicit CharacterRuns(const std::map<char32_t, uint16_t>& glyph_of);

  /// The runs that are not on pages.
  std::vector<uint8_t> cmap_section() const;
  /// Nothing if there are no pages.
  std::vector<uint8_t> code_pages_section() const;

  /// All runs.
  std::vector<uint8_t> cmap_of_all() const;

 private:
  struct Run {
    char32_t first;
    uint32_t extra;
    uint32_t glyph;
  };

  void find_pages();
  std::vector<uint8_t> entries(size_t without_from, size_t without_to) const;

  std::vector<Run> runs_;  // ascending
  size_t paged_from_ = 0;  // runs on pages
  size_t paged_to_ = 0;
};

}  // namespace inkcell::gen
