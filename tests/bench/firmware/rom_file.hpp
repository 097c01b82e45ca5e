// ROM fonts that the programs are given.
#pragma once

#include "console.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/font.hpp"

namespace bench {

// Reads a font into `bytes`, which must outlive it. False if it does not fit or
// does not open.
inline bool open_font(const char* name,
                      inkcell::Span<uint8_t> bytes,
                      inkcell::Font& font) {
  using namespace inkcell;
  const Span<const uint8_t> rom = {bytes.data,
                                   read_file(name, bytes.data, bytes.size)};
  return open_any_font(rom, font) == Status::ok;
}

}  // namespace bench
