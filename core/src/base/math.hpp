// The lesser and the greater of two numbers, and how far one is from 0.
#pragma once

#include <stdint.h>

namespace inkcell {
namespace detail {

inline int32_t lesser(int32_t a, int32_t b) noexcept {
  return a < b ? a : b;
}
inline int32_t greater(int32_t a, int32_t b) noexcept {
  return a > b ? a : b;
}

// Of any number but the least of all.
inline int32_t magnitude(int32_t value) noexcept {
  return value < 0 ? -value : value;
}

}  // namespace detail
}  // namespace inkcell
