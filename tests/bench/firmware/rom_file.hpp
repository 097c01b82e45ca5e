// ROM fonts that the programs are given.
#pragma once

#include "inkcell/field/draw.hpp"
#include "inkcell/font.hpp"
#include "semihosting.hpp"

namespace bench {

// Reads a font into `bytes`, which must outlive it. False if it does not fit or
// does not open.
inline bool open_font(const char* name,
                      inkcell::Span<uint8_t> bytes,
                      inkcell::Font& font) {
  using namespace inkcell;
  const intptr_t file = semihosting::open(name, semihosting::Mode::read);
  const intptr_t length = file < 0 ? -1 : semihosting::length(file);
  const auto size = static_cast<size_t>(length);
  return length >= 0 && size <= bytes.size &&
         semihosting::read(file, bytes.data, size) &&
         open_any_font({bytes.data, size}, font) == Status::ok;
}

}  // namespace bench
