// Composite glyphs of a font file.
#pragma once

#include <cstdint>
#include <vector>

#include "source/components.hpp"
#include "source/font_file.hpp"

namespace inkcell::gen {

/// The components of each of `glyphs` (ids in the font file) as indices into
/// `glyphs`. A component that is not among them is replaced by its own
/// components. Empty for a glyph that is no composite, that has other
/// components, or whose components, with offsets in whole font units and a
/// matrix in Q2.14, do not give its points within 1 font unit.
///
/// Throws Error if a glyph cannot be loaded.
std::vector<OutlineReferences> source_composites(
    const FontFile& file, const std::vector<uint32_t>& glyphs);

/// Components of `glyphs` that are not in `glyphs`, in ascending order: accents
/// without a code point, for example. With them more glyphs can become
/// composites. Those that are not referenced in the end need not be stored.
std::vector<uint32_t> missing_components(const FontFile& file,
                                         const std::vector<uint32_t>& glyphs);

}  // namespace inkcell::gen
