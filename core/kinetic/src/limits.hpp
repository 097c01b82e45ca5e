// Minimum, maximum, absolute value, clamps, rough lengths.
#pragma once

#include <stdint.h>

#include "base/math.hpp"

namespace inkcell::kinetic {

using detail::abs;
using detail::clamp;
using detail::clamp_i64;
using detail::max;
using detail::min;

constexpr int32_t kOneQ13 = 1 << 13;
constexpr int32_t kOneQ14 = 1 << 14;

// The length of a vector of components >= 0, within 3 %: max(m, 7/8 m + n / 2)
// with m >= n.
inline int32_t rough_length(int32_t x, int32_t y) noexcept {
  const int32_t most = max(x, y);
  return max(most, most - (most >> 3) + (min(x, y) >> 1));
}

}  // namespace inkcell::kinetic
