// A ROM font from a file.
#pragma once

#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

#include "inkcell/field/draw.hpp"
#include "inkcell/font.hpp"

// Its bytes, at an address that fonts may have.
class RomFile {
 public:
  explicit RomFile(const char* name) {
    std::ifstream file(name, std::ios::binary);
    const std::vector<char> loaded((std::istreambuf_iterator<char>(file)), {});
    size_ = loaded.size();
    words_.resize((size_ + 3) / 4);
    std::copy(loaded.begin(), loaded.end(),
              reinterpret_cast<uint8_t*>(words_.data()));
  }

  // False if it is no whole font. The file must outlive the font.
  bool open(inkcell::Font& font) const {
    return inkcell::open_any_font(
               {reinterpret_cast<const uint8_t*>(words_.data()), size_},
               font) == inkcell::Status::ok &&
           font.verify() == inkcell::Status::ok;
  }

 private:
  std::vector<uint32_t> words_;
  size_t size_ = 0;
};
