// Four bytes of a band at a time, the byte at the lowest address lowest.
#pragma once

#include <stdint.h>

#include "inkcell/assert.hpp"

namespace inkcell::detail {

// Two bytes of a word, each with room for what is carried.
inline constexpr uint32_t kEvenBytes = 0x00ff00ff;

inline uint32_t load_pixels(const uint8_t* at) noexcept {
  INKCELL_ASSERT(reinterpret_cast<uintptr_t>(at) % 4 == 0);
  uint32_t word;
  __builtin_memcpy(&word, __builtin_assume_aligned(at, 4), 4);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  word = __builtin_bswap32(word);
#endif
  return word;
}

inline void store_pixels(uint8_t* at, uint32_t word) noexcept {
  INKCELL_ASSERT(reinterpret_cast<uintptr_t>(at) % 4 == 0);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  word = __builtin_bswap32(word);
#endif
  __builtin_memcpy(__builtin_assume_aligned(at, 4), &word, 4);
}

// `bytes` is a multiple of 4.
inline void clear_pixels(uint8_t* at, int32_t bytes) noexcept {
  INKCELL_ASSERT(bytes >= 0 && bytes % 4 == 0);
  for (; bytes >= 32; bytes -= 32) {
    store_pixels(at, 0);
    store_pixels(at + 4, 0);
    store_pixels(at + 8, 0);
    store_pixels(at + 12, 0);
    store_pixels(at + 16, 0);
    store_pixels(at + 20, 0);
    store_pixels(at + 24, 0);
    store_pixels(at + 28, 0);
    at += 32;
  }
  for (; bytes != 0; bytes -= 4) {
    store_pixels(at, 0);
    at += 4;
  }
}

}  // namespace inkcell::detail
