// A ROM font from a file.
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

#include "inkcell/field/draw.hpp"
#include "inkcell/font.hpp"

// Its bytes, at an address that fonts may have.
class RomFile {
 public:
  // Ends the program if the file is no whole font, or none of the coding, if
  // that is given.
  explicit RomFile(const char* name, const inkcell::Coding* coding = nullptr) {
    std::ifstream file(name, std::ios::binary);
    const std::vector<char> loaded((std::istreambuf_iterator<char>(file)), {});
    words_.resize((loaded.size() + 3) / 4);
    std::copy(loaded.begin(), loaded.end(),
              reinterpret_cast<uint8_t*>(words_.data()));
    const inkcell::Span<const uint8_t> rom = {
        reinterpret_cast<const uint8_t*>(words_.data()), loaded.size()};
    if ((coding == nullptr ? inkcell::open_any_font(rom, font_)
                           : inkcell::Font::open(rom, *coding, font_)) !=
            inkcell::Status::ok ||
        font_.verify() != inkcell::Status::ok) {
      std::fprintf(stderr, "%s is no font\n", name);
      std::exit(2);
    }
  }

  // The file must outlive it.
  const inkcell::Font& font() const { return font_; }

 private:
  std::vector<uint32_t> words_;
  inkcell::Font font_;
};
