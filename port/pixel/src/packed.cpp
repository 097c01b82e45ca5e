// Solid runs in formats of several pixels a byte.
#include "packed.hpp"

namespace inkcell::port::detail {

namespace {

void merge(uint8_t& byte, uint8_t pattern, uint32_t mask) noexcept {
  byte = static_cast<uint8_t>(byte ^ ((byte ^ pattern) & mask));
}

// The bits of a byte from the pixel at bit `begin` (0..7) to the right end.
uint32_t mask_from(uint32_t begin, BitOrder order) noexcept {
  return order == BitOrder::high_left ? 0xffu >> begin : 0xffu << begin & 0xffu;
}

}  // namespace

void fill_packed(uint8_t* row,
                 uint32_t x,
                 uint32_t count,
                 uint32_t bits_log2,
                 uint8_t pattern,
                 BitOrder order) noexcept {
  const uint32_t begin = x << bits_log2;
  const uint32_t end = (x + count) << bits_log2;
  uint8_t* byte = row + (begin >> 3);
  uint8_t* const last = row + (end >> 3);
  uint32_t mask = mask_from(begin & 7, order);
  if (byte != last) {
    merge(*byte, pattern, mask);
    ++byte;
    __builtin_memset(byte, pattern, static_cast<size_t>(last - byte));
    mask = 0xff;
  }
  mask &= ~mask_from(end & 7, order);
  if (mask != 0) {  // else *last may be outside of the strip
    merge(*last, pattern, mask);
  }
}

}  // namespace inkcell::port::detail
