// Strikes as the device makes and draws them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "inkcell/font.hpp"
#include "rom/rom_content.hpp"

namespace inkcell::gen {

/// Opens a font in memory, whatever its coding.
Status open_font(const std::vector<uint8_t>& bytes, Font& out);

/// What the device makes of a font of outlines at one size.
struct DrawnStrike {
  RomStrike strike;
  std::vector<size_t> too_large;  // glyphs for which the format has no room
  /// Whether its advances and its kerning are whole pixels; there are none
  /// otherwise.
  bool is_whole = false;
  std::vector<int> advances_px;
  KerningMatrix kerning_px;
};

/// The first `count` glyphs of `content`, whose font `bytes` are; those of
/// bitmap fonts as they are in `source`. Glyphs for which the format has no
/// room get no picture.
DrawnStrike draw_strike(const SourceFont& source,
                        const RomContent& content,
                        const std::vector<uint8_t>& bytes,
                        const StrikeTarget& target,
                        size_t count);

/// Throws Error if the device draws glyph `id` of a font of strikes alone
/// otherwise than `content` has glyph `source`.
void check_picture(const RomContent& content,
                   size_t source,
                   const Font& font,
                   uint16_t id);

/// The same of all glyphs of the font `bytes`.
void check_strike_alone(const RomContent& content,
                        const std::vector<uint8_t>& bytes);

/// Throws Error if the font of outlines and strikes `bytes` is drawn otherwise
/// than from its outlines: at all with 1 and 2 bits, by more than 8/255 with 4.
void check_strikes(const RomContent& content,
                   const std::vector<uint8_t>& bytes);

}  // namespace inkcell::gen
