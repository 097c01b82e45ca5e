// Minimum, maximum and absolute value.
#pragma once

#include <stdint.h>

#include "inkcell/assert.hpp"

namespace inkcell {
namespace detail {

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

}  // namespace detail
}  // namespace inkcell
