// Minimum, maximum, absolute value, clamps, lengths, square roots, and numbers
// modulo 2^32.
#pragma once

#include <stdint.h>

#include "inkcell/assert.hpp"
#include "inkcell/fixed.hpp"

namespace inkcell::detail {

inline int32_t min(int32_t a, int32_t b) noexcept {
  return a < b ? a : b;
}
inline int32_t max(int32_t a, int32_t b) noexcept {
  return a > b ? a : b;
}

// Not of INT32_MIN.
inline int32_t abs(int32_t value) noexcept {
  INKCELL_ASSERT(value != INT32_MIN);
  return value < 0 ? -value : value;
}

inline uint32_t magnitude(int32_t value) noexcept {
  const auto same = static_cast<uint32_t>(value);
  return value < 0 ? 0 - same : same;
}

// As clamp(), of sums and products that may not fit 32 bits.
inline int32_t clamp_i64(int64_t value, int32_t low, int32_t high) noexcept {
  return static_cast<int32_t>(value < low ? low : value > high ? high : value);
}

// The quotient, rounded towards 0. Unsigned: division of signed numbers is one
// more routine on cores that have none.
inline int32_t quotient(int32_t dividend, int32_t divisor) noexcept {
  const auto over = static_cast<uint32_t>(divisor);
  const auto from = static_cast<uint32_t>(dividend);
  return dividend < 0 ? -static_cast<int32_t>((0u - from) / over)
                      : static_cast<int32_t>(from / over);
}

// Whether the compiler was asked for small code.
#if defined(__OPTIMIZE_SIZE__)
inline constexpr bool kIsSmall = true;
#else
inline constexpr bool kIsSmall = false;
#endif

// The length of a vector within 12 %.
inline int32_t rough_length(int32_t x, int32_t y) noexcept {
  const int32_t a = abs(x);
  const int32_t b = abs(y);
  return max(a, b) + (min(a, b) * 3 >> 3);
}

// The length of a vector of components >= 0, within 3 %: max(m, 7/8 m + n / 2)
// with m >= n.
inline int32_t near_length(int32_t x, int32_t y) noexcept {
  const int32_t most = max(x, y);
  return max(most, most - (most >> 3) + (min(x, y) >> 1));
}

// The square root rounded down, of an unsigned number of 32 or 64 bits; `rest`
// is what its square lacks.
template <typename Word>
constexpr uint32_t root_of(Word value, Word& rest) noexcept {
  Word root = 0;
  for (Word bit = Word{1} << (8 * sizeof(Word) - 2); bit != 0; bit >>= 2) {
    const Word sum = root + bit;
    root >>= 1;
    if (value >= sum) {
      value -= sum;
      root += bit;
    }
  }
  rest = value;
  return static_cast<uint32_t>(root);
}
template <typename Word>
constexpr uint32_t root_of(Word value) noexcept {
  Word rest = 0;
  return root_of(value, rest);
}

// To the nearest.
constexpr uint32_t nearest_root_of(uint32_t value) noexcept {
  uint32_t rest = 0;
  const uint32_t root = root_of(value, rest);
  return root + (rest > root ? 1 : 0);
}

inline void swap(int32_t& a, int32_t& b) noexcept {
  const int32_t before = a;
  a = b;
  b = before;
}

// Whether 0 <= at < end, and 0 <= at <= last, by one comparison.
inline bool is_below(int32_t at, int32_t end) noexcept {
  return static_cast<uint32_t>(at) < static_cast<uint32_t>(end);
}
inline bool is_up_to(int32_t at, int32_t last) noexcept {
  return static_cast<uint32_t>(at) <= static_cast<uint32_t>(last);
}

// Products and sums modulo 2^32.
inline uint32_t times(int32_t a, uint32_t b) noexcept {
  return static_cast<uint32_t>(a) * b;
}
inline int32_t wrapped(uint32_t value) noexcept {
  return static_cast<int32_t>(value);
}
inline int32_t product(int32_t a, int32_t b) noexcept {
  return wrapped(times(a, static_cast<uint32_t>(b)));
}
inline int32_t sum(int32_t a, int32_t b) noexcept {
  return wrapped(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
}

}  // namespace inkcell::detail
