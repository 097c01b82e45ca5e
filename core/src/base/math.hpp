// Minimum, maximum, absolute value and clamps.
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

}  // namespace inkcell::detail
