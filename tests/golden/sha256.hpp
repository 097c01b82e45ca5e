// SHA-256 (FIPS 180-4), freestanding: 108 bytes of state, no tables in RAM.
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"

namespace golden {

struct Hash {
  uint8_t bytes[32];
  /// 64 digits and a zero.
  void to_hex(char (&out)[65]) const;
};

class Sha256 {
 public:
  void add(inkcell::Span<const uint8_t> bytes);
  /// The hash of everything added; nothing may be added afterwards.
  Hash finish();

 private:
  void add_byte(uint8_t byte);
  void compress();

  uint32_t state_[8] = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  uint8_t block_[64] = {};
  uint64_t size_ = 0;  // bytes added
};

}  // namespace golden
