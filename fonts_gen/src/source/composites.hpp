// Composite glyphs of a font file.
#pragma once

#include <cstdint>
#include <vector>

#include "source/components.hpp"
#include "source/font_file.hpp"

namespace inkcell::gen {

/// For each of `glyphs`, which are ids in the font file, its components by
/// their places in `glyphs`. A component that is not among them is replaced by
/// its own components. Empty for a glyph that is no composite, that has other
/// components, or whose components, with offsets in whole font units and a
/// matrix in Q2.14, do not give its points within 1 font unit.
///
/// Throws Error if a glyph cannot be loaded.
std::vector<OutlineReferences> source_composites(
    const FontFile& file, const std::vector<uint32_t>& glyphs);

/// Glyphs that are not in `glyphs` but components of them, in ascending order:
/// accents without a code point, for example. With them as glyphs without code
/// points, more glyphs can be composites; those to which no composite refers in
/// the end need not be stored.
std::vector<uint32_t> missing_components(const FontFile& file,
                                         const std::vector<uint32_t>& glyphs);

}  // namespace inkcell::gen
