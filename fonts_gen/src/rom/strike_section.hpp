// Strikes as the bytes of STRK, or of GLYF in fonts of strikes alone.
#pragma once

#include <cstdint>
#include <vector>

#include "source/picture.hpp"
#include "target/target.hpp"

namespace inkcell::gen {

/// The pictures of the first glyphs of a font.
struct RomStrike {
  StrikeTarget target;
  std::vector<Picture> pictures;
};

/// The section; alone in a font, whose METR has the boxes, or beside outlines.
/// All pictures are in the format.
std::vector<uint8_t> strikes_section(const std::vector<RomStrike>& strikes,
                                     bool is_alone);

}  // namespace inkcell::gen
