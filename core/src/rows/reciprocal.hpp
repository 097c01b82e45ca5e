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

#if defined(__ARM_ARCH_6M__)
// No division there: a table of 64 bytes, a step of Newton's method, and a
// remainder that makes it exact.
Reciprocal reciprocal_of(uint32_t d) noexcept;
#else
// 0 < d < kLengthLimit.
inline Reciprocal reciprocal_of(uint32_t d) noexcept {
#  if defined(__riscv) && !defined(__riscv_zbb)
  uint32_t zeros = 0;
  uint32_t scaled = d;
  if (scaled < 1u << 8) {
    scaled <<= 8;
    zeros = 8;
  }
  if (scaled < 1u << 12) {
    scaled <<= 4;
    zeros += 4;
  }
  if (scaled < 1u << 14) {
    scaled <<= 2;
    zeros += 2;
  }
  if (scaled < 1u << 15) {
    scaled <<= 1;
    zeros += 1;
  }
#  else
  const uint32_t zeros = static_cast<uint32_t>(__builtin_clz(d)) - 16;
  const uint32_t scaled = d << zeros;
#  endif
  return {static_cast<int32_t>(0x7fffffffu / scaled), 15 - zeros};
}
#endif

// 2^16 a / d; |a| < kLengthLimit.
inline int32_t times(int32_t a, const Reciprocal& over_d) noexcept {
  return a * over_d.value >> over_d.shift;
}

}  // namespace inkcell::detail
