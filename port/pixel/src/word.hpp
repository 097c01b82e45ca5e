// Access to two or four bytes of a strip at once, in the machine's byte order.
#pragma once

#include <stdint.h>

namespace inkcell::port::detail {

/// `bytes` must be a multiple of 4: some cores trap otherwise.
inline uint32_t load_word(const uint8_t* bytes) noexcept {
  uint32_t word;
  __builtin_memcpy(&word, __builtin_assume_aligned(bytes, 4), 4);
  return word;
}

/// `bytes` must be a multiple of 4.
inline void store_word(uint8_t* bytes, uint32_t word) noexcept {
  __builtin_memcpy(__builtin_assume_aligned(bytes, 4), &word, 4);
}

/// Whether unaligned words are as fast as aligned ones.
#if defined(__ARM_FEATURE_UNALIGNED) || defined(__x86_64__)
inline constexpr bool kAnyAddress = true;
#else
inline constexpr bool kAnyAddress = false;
#endif

/// At any address; slow on cores without unaligned loads.
inline uint32_t load_any_word(const uint8_t* bytes) noexcept {
  uint32_t word;
  __builtin_memcpy(&word, bytes, 4);
  return word;
}
inline void store_any_word(uint8_t* bytes, uint32_t word) noexcept {
  __builtin_memcpy(bytes, &word, 4);
}

/// Two bytes, at an even address.
inline uint32_t load_half(const uint8_t* bytes) noexcept {
  uint16_t half;
  __builtin_memcpy(&half, __builtin_assume_aligned(bytes, 2), 2);
  return half;
}
inline void store_half(uint8_t* bytes, uint32_t value) noexcept {
  const auto half = static_cast<uint16_t>(value);
  __builtin_memcpy(__builtin_assume_aligned(bytes, 2), &half, 2);
}

#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
inline constexpr bool kLittleEndian = false;
#else
inline constexpr bool kLittleEndian = true;
#endif

/// The word with these bytes in memory, in either byte order.
inline uint32_t word_of(uint32_t byte0,
                        uint32_t byte1,
                        uint32_t byte2,
                        uint32_t byte3) noexcept {
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  return byte0 << 24 | byte1 << 16 | byte2 << 8 | byte3;
#else
  return byte3 << 24 | byte2 << 16 | byte1 << 8 | byte0;
#endif
}

}  // namespace inkcell::port::detail
