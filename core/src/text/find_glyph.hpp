// From a code point to the glyph that text shows.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "text/blank.hpp"

namespace inkcell {
namespace detail {

// What becomes of a character: Shown::glyph, `glyph` is to be drawn; nothing;
// Shown::space, a width and no glyph, because the font has no space at all.
// Only characters that show something become .notdef where the font lacks them.
inline Shown find_glyph(const Font& font,
                        uint32_t code_point,
                        uint16_t& glyph) noexcept {
  const Shown shown = shown_as(code_point);
  if (shown == Shown::nothing) {
    return shown;
  }
  if (code_point == '\t') {
    code_point = ' ';
  }
  if (font.glyph_of(code_point, glyph) == Status::ok || shown == Shown::glyph) {
    return Shown::glyph;
  }
  return shown == Shown::space && font.glyph_of(' ', glyph) == Status::ok
             ? Shown::glyph
             : shown;
}

}  // namespace detail
}  // namespace inkcell
