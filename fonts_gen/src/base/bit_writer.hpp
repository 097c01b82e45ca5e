// Bits of a record, from the highest of a byte to its lowest.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace inkcell::gen {

class BitWriter {
 public:
  /// Appends the lowest `bits` bits of `value`, the highest of them first.
  /// Negative numbers are two's complement.
  void put(int value, int bits) {
    for (int i = bits - 1; i >= 0; --i) {
      if (used_ == 0) {
        bytes_.push_back(0);
      }
      const unsigned bit = static_cast<unsigned>(value) >> i & 1;
      bytes_.back() = static_cast<uint8_t>(bytes_.back() | bit << (7 - used_));
      used_ = (used_ + 1) % 8;
    }
  }

  /// The bytes without trailing zero bytes, which readers supply.
  std::vector<uint8_t> take() {
    while (!bytes_.empty() && bytes_.back() == 0) {
      bytes_.pop_back();
    }
    used_ = 0;
    return std::move(bytes_);
  }

 private:
  std::vector<uint8_t> bytes_;
  int used_ = 0;  // bits of the last byte; 0: all
};

}  // namespace inkcell::gen
