// Puts right what would make Font::open refuse bytes at once.
#pragma once

#include <stdint.h>

#include <algorithm>

#include "font_builder.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"
#include "inkcell/version.hpp"

/// Magic, version, sizes and checksums; the rest stays as it is.
inline void repair_font(inkcell::Span<uint8_t> font) {
  using namespace inkcell;
  using font_builder::get_u16;
  using font_builder::get_u32;
  namespace header = format::header;
  if (font.size < header::kBytes) {
    return;
  }
  uint8_t* at = font.data;
  font_builder::put_u32(at + header::kMagic, format::kMagic);
  at[header::kFormatMajor] = kFormatMajor;
  at[header::kFormatMinor] = kFormatMinor;
  at[header::kCoding] &= static_cast<uint8_t>(format::Coding::outline);
  const auto size = static_cast<uint32_t>(font.size);
  const uint32_t room = (size - header::kBytes) / format::section::kBytes;
  const uint32_t sections = std::min(
      std::min(get_u16(at + header::kSectionCount), room), uint32_t{32});
  font_builder::put_u16(at + header::kSectionCount, sections);
  font_builder::put_u16(at + header::kHeaderBytes,
                        header::kBytes + sections * format::section::kBytes);
  if (get_u32(at + header::kTotalBytes) > size) {
    font_builder::put_u32(at + header::kTotalBytes, size);
  }
  font_builder::repair_checksums(font);
}
