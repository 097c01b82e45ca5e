// The sample font of outlines in RAM, opened: one for all tests of a program.
#pragma once

#include "check.hpp"
#include "inkcell/font.hpp"
#include "outline_record.hpp"

namespace outline_record {

/// Not for tests that change bytes of it.
inline const inkcell::Font& sample_font() {
  alignas(4) static uint8_t rom[kSampleFontBytes];
  static inkcell::Font font;
  if (font.glyph_count() == 0) {
    CHECK_OK(inkcell::Font::open({rom, build_sample_font(rom)}, font));
  }
  return font;
}

}  // namespace outline_record
