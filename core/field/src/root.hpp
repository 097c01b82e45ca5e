// Square roots of integers.
#pragma once

#include <stdint.h>

namespace inkcell {
namespace detail {

// The root rounded down; `rest` is what its square lacks.
inline uint32_t root_of(uint32_t value, uint32_t& rest) noexcept {
  uint32_t root = 0;
  for (uint32_t bit = uint32_t{1} << 30; bit != 0; bit >>= 2) {
    const uint32_t sum = root + bit;
    root >>= 1;
    if (value >= sum) {
      value -= sum;
      root += bit;
    }
  }
  rest = value;
  return root;
}
inline uint32_t root_of(uint32_t value) noexcept {
  uint32_t rest;
  return root_of(value, rest);
}

}  // namespace detail
}  // namespace inkcell
