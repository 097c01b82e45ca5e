// Which glyphs are stored as references to others.
#pragma once

#include <cstddef>
#include <vector>

#include "outlines/minimal_outline.hpp"
#include "outlines/outline_record.hpp"
#include "source/components.hpp"

namespace inkcell::gen {

/// A glyph that may become a composite.
struct CompositeCandidate {
  MinimalOutline outline;
  /// Bytes of its record as a simple outline; 0: no ink.
  size_t simple_bytes = 0;
  /// Its components in the font file, as far as all of them are glyphs of this
  /// font; they may be composites themselves.
  OutlineReferences source;
};

/// For each glyph the references of its record, which are to glyphs without
/// references; none: a simple outline.
///
/// Takes the components of the source, else a search: other glyphs that, moved
/// by whole font units, have together exactly the contours of the glyph. In
/// both cases only if that takes fewer bytes, and no component overlaps or
/// touches another one. A grid unit is 2^grid_shift font units.
std::vector<OutlineReferences> find_composites(
    const std::vector<CompositeCandidate>& glyphs, int grid_shift);

/// Whether the ink of two components overlaps, or their borders come nearer
/// than two grid units.
bool components_overlap(const std::vector<CompositeCandidate>& glyphs,
                        const OutlineReference& a,
                        const OutlineReference& b,
                        int grid_shift);

}  // namespace inkcell::gen
