// Reads numbers of so many bits, the highest first, as the tests' own decoders
// do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace inkcell::gen::test {

// Beyond the end there are zeros.
class Bits {
 public:
  explicit Bits(const std::vector<uint8_t>& bytes) : bytes_(bytes) {}

  int u(int count) {
    int value = 0;
    for (int i = 0; i < count; ++i, ++at_) {
      const int byte = at_ / 8 < bytes_.size() ? bytes_[at_ / 8] : 0;
      value = 2 * value + (byte >> (7 - at_ % 8) & 1);
    }
    return value;
  }

  int s(int count) {
    const int value = u(count);
    return count > 0 && value >> (count - 1) != 0 ? value - (1 << count)
                                                  : value;
  }

  void seek(size_t bit) { at_ = bit; }
  size_t at() const { return at_; }

 private:
  const std::vector<uint8_t>& bytes_;
  size_t at_ = 0;
};

}  // namespace inkcell::gen::test
