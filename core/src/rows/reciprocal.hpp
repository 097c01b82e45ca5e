// Quotients of lengths: one division, then products.
#pragma once

#include <stdint.h>

namespace inkcell::detail {

// 2^16 / d as value / 2^shift, value below 2^16: rounded down, so that products
// are up to 2^-15 of themselves too small. The same on every core.
struct Reciprocal {
  int32_t value;
  uint32_t shift;
};

// Lengths below this have reciprocals, and quotients of them fit 32 bits.
inline constexpr int32_t kLengthLimit = 1 << 15;

// Shifts 0 < d < 2^16 until its highest bit is bit 15; returns which it was.
inline uint32_t normalize(uint32_t& d) noexcept {
#if defined(__ARM_ARCH_6M__) || (defined(__riscv) && !defined(__riscv_zbb))
  uint32_t bit = 15;
  if (d < 1u << 8) {
    d <<= 8;
    bit = 7;
  }
  if (d < 1u << 12) {
    d <<= 4;
    bit -= 4;
  }
  if (d < 1u << 14) {
    d <<= 2;
    bit -= 2;
  }
  if (d < 1u << 15) {
    d <<= 1;
    bit -= 1;
  }
#else
  const uint32_t zeros = static_cast<uint32_t>(__builtin_clz(d)) - 16;
  d <<= zeros;
  const uint32_t bit = 15 - zeros;
#endif
  return bit;
}

#if defined(__ARM_ARCH_6M__)
// No division there: a table of 64 bytes, a step of Newton's method, and a
// remainder that makes it exact.
Reciprocal reciprocal_of(uint32_t d) noexcept;
#else
// 0 < d < kLengthLimit.
inline Reciprocal reciprocal_of(uint32_t d) noexcept {
  const uint32_t shift = normalize(d);
  return {static_cast<int32_t>(0x7fffffffu / d), shift};
}
#endif

// 2^16 a / d; |a| < kLengthLimit.
inline int32_t times(int32_t a, const Reciprocal& over_d) noexcept {
  return a * over_d.value >> over_d.shift;
}

}  // namespace inkcell::detail
