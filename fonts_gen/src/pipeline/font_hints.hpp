// The hints of a whole font, from the outlines that the device decodes.
#pragma once

#include "rom/rom_content.hpp"

namespace inkcell::gen {

/// The hints of `content`, whose records must be encoded and whose glyph_of
/// must be complete. `jobs`: threads; 0: all cores.
FontHints find_hints(const RomContent& content, int jobs);

}  // namespace inkcell::gen
