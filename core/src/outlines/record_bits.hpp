// Bits of a record, from the highest of a byte to its lowest, read one by one:
// for what is not drawn in a loop.
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"

namespace inkcell {
namespace detail {

// `count` bits from `bit` on, at most 16; 0 beyond the end.
inline uint32_t bits_at(Span<const uint8_t> bytes,
                        uint32_t bit,
                        uint32_t count) noexcept {
  uint32_t window = 0;
  for (uint32_t i = bit >> 3; i != (bit >> 3) + 3; ++i) {
    window = window << 8 | (i < bytes.size ? bytes.data[i] : 0u);
  }
  return window >> (24 - (bit & 7) - count) & ~(~0u << count);
}

// The same in two's complement.
inline int32_t signed_bits_at(Span<const uint8_t> bytes,
                              uint32_t bit,
                              uint32_t count) noexcept {
  const uint32_t sign = 1u << count >> 1;
  return static_cast<int32_t>(bits_at(bytes, bit, count) ^ sign) -
         static_cast<int32_t>(sign);
}

}  // namespace detail
}  // namespace inkcell
