// Minimum, maximum, absolute value, clamp, rough lengths.
#pragma once

#include <stdint.h>

#include "base/math.hpp"

namespace inkcell {
namespace kinetic {

using detail::abs;
using detail::max;
using detail::min;

constexpr int32_t kOneQ13 = 1 << 13;
constexpr int32_t kOneQ14 = 1 << 14;

inline int32_t clamp(int32_t value, int32_t low, int32_t high) noexcept {
  return value < low ? low : value > high ? high : value;
}

// Clamps sums and products that may not fit 32 bits.
inline int32_t clamp_i64(int64_t value, int32_t low, int32_t high) noexcept {
  return static_cast<int32_t>(value < low ? low : value > high ? high : value);
}

// The length of a vector of components >= 0, within 3 %: max(m, 7/8 m + n / 2)
// with m >= n.
inline int32_t rough_length(int32_t x, int32_t y) noexcept {
  const int32_t most = max(x, y);
  return max(most, most - (most >> 3) + (min(x, y) >> 1));
}

}  // namespace kinetic
}  // namespace inkcell
