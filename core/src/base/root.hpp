// Square roots of integers.
#pragma once

#include <stdint.h>

namespace inkcell::detail {

// The root rounded down, of an unsigned number of 32 or 64 bits; `rest` is what
// its square lacks.
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

}  // namespace inkcell::detail
