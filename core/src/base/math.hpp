// The lesser and the greater of two numbers, and how far one is from 0.
#pragma once

#include <stdint.h>

namespace inkcell {
namespace detail {

inline int32_t min(int32_t a, int32_t b) noexcept {
  return a < b ? a : b;
}
inline int32_t max(int32_t a, int32_t b) noexcept {
  return a > b ? a : b;
}

// Of any number but the least of all.
inline int32_t abs(int32_t value) noexcept {
  return value < 0 ? -value : value;
}

}  // namespace detail
}  // namespace inkcell
