// A small font in RAM that tests change and open again.
#pragma once

#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/verify.hpp"
#include "inkcell/font.hpp"

namespace sample_rom {

using namespace inkcell;
using namespace font_builder;
namespace header = format::header;
namespace section = format::section;

alignas(4) inline uint8_t rom[kSampleFontBytes + 512];
inline size_t rom_bytes = 0;

// A fresh sample font in `rom`, opened.
inline Font sample() {
  rom_bytes = build_sample_font({rom, kSampleFontBytes});
  Font font;
  CHECK(rom_bytes != 0);
  CHECK_OK(open_any_font({rom, rom_bytes}, font));
  return font;
}

// What open says after the header or directory was changed.
inline Status reopen(Font* out = nullptr) {
  CHECK(repair_checksums({rom, rom_bytes}));
  Font font;
  const Status status = open_any_font({rom, rom_bytes}, font);
  CHECK(status == Status::ok || font.glyph_count() == 0);  // out untouched
  if (out != nullptr) {
    *out = font;
  }
  return status;
}

// The changed font, which must open.
inline Font reopened() {
  Font font;
  CHECK_OK(reopen(&font));
  return font;
}

// What verify says of it.
inline Status verify_changed() {
  const Font font = reopened();
  return font.has_outlines() ? font.verify() : verify_fields(font);
}

inline uint8_t* entry_of(uint32_t tag) {
  uint8_t* entry = rom + header::kBytes;
  while (get_u32(entry + section::kTag) != tag) {
    entry += section::kBytes;
  }
  return entry;
}

inline uint8_t* section_bytes(uint32_t tag) {
  return rom +
         (get_u32(entry_of(tag) + section::kOffset) & section::kOffsetMask);
}

}  // namespace sample_rom
