// Characters that show nothing.
#pragma once

#include <stdint.h>

namespace inkcell::detail {

enum class Shown : uint8_t {
  glyph,
  space,    // as wide as a space where the font has no glyph of its own
  nothing,  // no glyph and no width, whatever the font has
  mark,     // the same, but where the font has a glyph of its own
};

// Controls, line ends and default ignorable code points (zero width characters,
// soft hyphen, variation selectors, directional controls) show nothing; tabs
// and spaces of all kinds are spaces. Combining marks are those of Latin,
// Greek, Cyrillic, Hebrew, Arabic, Thai, kana and symbols: all of Unicode would
// be 500 bytes in every program.
Shown shown_as(uint32_t code_point) noexcept;

}  // namespace inkcell::detail
