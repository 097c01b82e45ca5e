// Section GRID (docs/FORMAT.md): hints to bytes.
#pragma once

#include <cstdint>
#include <vector>

#include "hints/glyph_hints.hpp"

namespace inkcell::gen {

/// The record of a glyph; empty if it has no hints.
std::vector<uint8_t> hint_record(const GlyphHints& hints);

/// The section up to its offsets, which have `offset_bits` bits.
std::vector<uint8_t> grid_head(const FaceHints& face, unsigned offset_bits);

/// The section, without padding; nothing for a font without hints.
std::vector<uint8_t> grid_section(const FontHints& hints);

}  // namespace inkcell::gen
