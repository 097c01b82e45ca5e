// The outlines of a font together: their code, their records, their references.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "rom/rom_content.hpp"

namespace inkcell::gen {

/// Makes the code table of all outlines and the record of each. Glyphs with
/// references get the record of a composite. Throws GeometryError if an outline
/// does not fit the format.
void encode_outlines(RomContent& content);

/// The same with a code that is made without a search, for trials: the device
/// draws the same, from more bytes.
void encode_outlines_widely(RomContent& content);

/// The outline that the device decodes: that of the record, or those of the
/// components of a composite. [u]
Outline decoded_outline(const RomContent& content, size_t glyph);

/// Replaces outlines by references to other glyphs where that takes fewer
/// bytes. `source`: the components of each glyph in the font file. The records
/// must be encoded before, and anew afterwards.
void find_references(const std::vector<OutlineReferences>& source,
                     RomContent& content);

/// The glyphs that are needed: those for which `is_needed` is true, and those
/// to which they refer. References are changed to places in the result.
std::vector<size_t> used_glyphs(RomContent& content,
                                const std::function<bool(size_t)>& is_needed);

}  // namespace inkcell::gen
