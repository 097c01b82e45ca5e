// Bit tables of the container: rows of numbers without gaps.
#pragma once

#include <cstdint>
#include <vector>

namespace inkcell::gen {

/// Bits that it takes to write every number up to `most`.
inline unsigned width_of(uint32_t most) {
  unsigned width = 0;
  while (most >> width != 0) {
    ++width;
  }
  return width;
}

/// Appends numbers, the first in the lowest bits of a new byte.
class BitTableWriter {
 public:
  explicit BitTableWriter(std::vector<uint8_t>& out) : out_(out) {}

  void put(uint32_t value, unsigned width) {
    for (unsigned bit = 0; bit < width; ++bit, ++written_) {
      if (written_ % 8 == 0) {
        out_.push_back(0);
      }
      if ((value >> bit & 1) != 0) {
        out_.back() = static_cast<uint8_t>(out_.back() | 1u << written_ % 8);
      }
    }
  }

 private:
  std::vector<uint8_t>& out_;
  uint64_t written_ = 0;  // bits
};

}  // namespace inkcell::gen
