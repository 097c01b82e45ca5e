// Bits of a record, from the highest of a byte to its lowest.
#pragma once

#include <cstddef>
#include <cstdint>

#include "inkcell/span.hpp"

namespace inkcell::tools {

/// Reads zeros after the end.
class BitReader {
 public:
  BitReader(Span<const uint8_t> bytes, size_t first_bit)
      : bytes_(bytes), bit_(first_bit) {}

  uint32_t peek(int count) const {
    uint32_t value = 0;
    for (size_t i = bit_; i < bit_ + static_cast<size_t>(count); ++i) {
      const uint32_t byte = i / 8 < bytes_.size ? bytes_.data[i / 8] : 0;
      value = value << 1 | (byte >> (7 - i % 8) & 1);
    }
    return value;
  }
  uint32_t read(int count) {
    const uint32_t value = peek(count);
    bit_ += static_cast<size_t>(count);
    return value;
  }
  int read_signed(int count) {
    const auto value = static_cast<int>(read(count));
    return count > 0 && value >> (count - 1) != 0 ? value - (1 << count)
                                                  : value;
  }
  bool is_at_end() const { return bit_ >= 8 * bytes_.size; }

 private:
  Span<const uint8_t> bytes_;
  size_t bit_;
};

}  // namespace inkcell::tools
