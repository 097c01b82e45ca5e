// From a code point to the glyph that text shows.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "text/blank.hpp"

namespace inkcell {
namespace detail {

// False: nothing is to be drawn. Only characters that show something become
// .notdef where the font lacks them.
inline bool find_glyph(const Font& font,
                       uint32_t code_point,
                       uint16_t& glyph) noexcept {
  const Shown shown = shown_as(code_point);
  if (shown == Shown::nothing) {
    return false;
  }
  if (code_point == '\t') {
    code_point = ' ';
  }
  if (font.glyph_of(code_point, glyph) == Status::ok || shown == Shown::glyph) {
    return true;
  }
  return shown == Shown::space && font.glyph_of(' ', glyph) == Status::ok;
}

}  // namespace detail
}  // namespace inkcell
