// A plain reader of section MORP, from docs/FORMAT.md alone.
#pragma once

#include <cstdint>
#include <vector>

#include "outlines/minimal_outline.hpp"
#include "shape/outline.hpp"

namespace inkcell::gen::test {

/// A pair of glyphs and its record.
struct MorphEntry {
  int first;
  int second;
  std::vector<uint8_t> record;
};

/// The pairs of a section.
std::vector<MorphEntry> read_morphs(const std::vector<uint8_t>& section);

/// The contours of a pair at a progress, each curve as `chords` lines. [grid
/// units] Throws std::out_of_range if the record leaves the outlines.
std::vector<std::vector<Point>> read_morph(const std::vector<uint8_t>& record,
                                           const MinimalOutline& first,
                                           const MinimalOutline& second,
                                           double progress,
                                           int chords);

}  // namespace inkcell::gen::test
