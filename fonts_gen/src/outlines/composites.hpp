// Chooses the glyphs that are stored as references to others.
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
  /// Its components in the font file, if all of them are glyphs of this font;
  /// they may be composites themselves.
  OutlineReferences source;
};

/// The references of each glyph's record; none for a simple outline. References
/// are to simple outlines only.
///
/// Uses the components of the source, else searches for glyphs that, moved by
/// whole font units, together have exactly the contours of the glyph. A
/// composite must take fewer bytes, and its components must not overlap or
/// touch. A grid unit is 2^grid_shift font units.
std::vector<OutlineReferences> find_composites(
    const std::vector<CompositeCandidate>& glyphs, int grid_shift);

/// Whether two components overlap, or their borders come nearer than two grid
/// units.
bool components_overlap(const std::vector<CompositeCandidate>& glyphs,
                        const OutlineReference& a,
                        const OutlineReference& b,
                        int grid_shift);

}  // namespace inkcell::gen
