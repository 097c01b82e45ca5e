// A font in pages, for storage that is not mapped.
#pragma once

#include <cstdint>
#include <vector>

#include "rom/rom_content.hpp"
#include "rom/rom_font.hpp"

namespace inkcell::gen {

/// The bytes of a paged font as docs/FORMAT.md states them, of blocks of
/// content.block_bytes. Glyphs lie in the order of their code points; one that
/// has several far apart lies on several pages. `parts` is filled in. Throws
/// Error if a glyph is larger than a block, or the resident part too large.
std::vector<uint8_t> write_paged_font(const RomContent& content,
                                      PartBytes& parts);

}  // namespace inkcell::gen
