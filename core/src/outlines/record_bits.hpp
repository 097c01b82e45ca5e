// Bits of a record, from the highest of a byte to its lowest.
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"

namespace inkcell::detail {

inline uint32_t load_big_u32(const uint8_t* at) noexcept {
  return uint32_t{at[0]} << 24 | uint32_t{at[1]} << 16 | uint32_t{at[2]} << 8 |
         at[3];
}

// bits_from() where fewer than four bytes are left.
uint32_t last_bits_from(const uint8_t* bytes,
                        uint32_t size,
                        uint32_t first) noexcept;

// The bits from `bit` on, the next one highest: 25 at least, 0 beyond the end.
inline uint32_t bits_from(const uint8_t* bytes,
                          uint32_t size,
                          uint32_t bit) noexcept {
  const uint32_t first = bit >> 3;
  const auto last_four = static_cast<int32_t>(size - 4);
  const uint32_t window =
      __builtin_expect(static_cast<int32_t>(first) <= last_four, 1)
          ? load_big_u32(bytes + first)
          : last_bits_from(bytes, size, first);
  return window << (bit & 7);
}

// `count` bits from `bit` on, 1 to 16; 0 beyond the end.
inline uint32_t bits_at(const Span<const uint8_t>& bytes,
                        uint32_t bit,
                        uint32_t count) noexcept {
  return bits_from(bytes.data, static_cast<uint32_t>(bytes.size), bit) >>
         (32 - count);
}

}  // namespace inkcell::detail
