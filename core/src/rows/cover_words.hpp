// From painted words to coverage.
#pragma once

#include <stdint.h>

#include "base/words.hpp"
#include "rows/band.hpp"

namespace inkcell::detail {

// A band's words of four pixels to coverage, row by row. `first`: as Words are
// at the beginning of each.
template <typename Words>
__attribute__((always_inline)) inline void cover_words(
    const Band& band, const Words& first) noexcept {
  uint8_t* at = band.bytes;
  const int32_t row_bytes = band.row_bytes();
  const int32_t skipped = band.stride - row_bytes;
  for (int32_t row = band.rows; row != 0; --row) {
    Words words = first;
    uint8_t* const end = at + row_bytes;
    do {
      const uint32_t bytes = load_pixels(at);
      store_pixels(at, __builtin_expect(bytes == 0, 1) ? words.same()
                                                       : words.next(bytes));
      at += 4;
    } while (at != end);
    at += skipped;
  }
}

}  // namespace inkcell::detail
