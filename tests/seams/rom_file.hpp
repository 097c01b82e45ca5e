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
  // Ends the program if the file is no whole font.
  explicit RomFile(const char* name) {
    std::ifstream file(name, std::ios::binary);
    const std::vector<char> loaded((std::istreambuf_iterator<char>(file)), {});
    words_.resize((loaded.size() + 3) / 4);
    std::copy(loaded.begin(), loaded.end(),
              reinterpret_cast<uint8_t*>(words_.data()));
    if (inkcell::open_any_font(
            {reinterpret_cast<const uint8_t*>(words_.data()), loaded.size()},
            font_) != inkcell::Status::ok ||
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
