// A Status that nobody looks at.
// refused: nodiscard|unused-result
#include "inkcell/font.hpp"

inkcell::Status open_font(inkcell::Span<const uint8_t> rom,
                          inkcell::Font& font) noexcept {
#if REFUSED
  inkcell::Font::open(rom, font);
  return inkcell::Status::ok;
#else
  return inkcell::Font::open(rom, font);
#endif
}
