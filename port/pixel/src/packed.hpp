// Formats of 1, 2 or 4 bits a pixel: the position of a pixel in its byte.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"
#include "run.hpp"

namespace inkcell::port::detail {

/// The shift of the lowest bit of pixel `x` in its byte.
inline uint32_t packed_shift(uint32_t x,
                             uint32_t bits_log2,
                             BitOrder order) noexcept {
  const uint32_t last = (8u >> bits_log2) - 1;  // pixel of a byte
  const uint32_t place =
      order == BitOrder::high_left ? last - (x & last) : x & last;
  return place << bits_log2;
}

/// Sets `count` (1 or more) pixels of a row from `x` on to `pattern`, a byte
/// full of one level.
void fill_packed(uint8_t* row,
                 uint32_t x,
                 uint32_t count,
                 uint32_t bits_log2,
                 uint8_t pattern,
                 BitOrder order) noexcept;

/// Blends `count` (1 or more) pixels of a row from `x` on, on the levels that
/// their bits hold. Inline, so that bits_log2 is a constant.
inline void blend_packed(uint8_t* row,
                         uint32_t x,
                         const uint8_t* coverage,
                         uint32_t count,
                         uint32_t bits_log2,
                         uint8_t level,
                         BitOrder order) noexcept {
  const uint32_t bits = 1u << bits_log2;
  const uint32_t mask = (1u << bits) - 1;
  // A level that is too large must not change the next pixel.
  const uint32_t above = level & mask;
  uint8_t* at = row + (x >> (3 - bits_log2));
  uint32_t shift = packed_shift(x, bits_log2, order);
  const uint32_t step = order == BitOrder::high_left ? 0 - bits : bits;
  uint32_t byte = *at;
  for (const uint8_t* const end = coverage + count;;) {
    // blend() with one multiplication; coverage 0 leaves the pixel unchanged.
    const uint32_t old = byte >> shift & mask;
    const uint32_t mixed =
        divide_by_255(255 * old + *coverage++ * (above - old));
    byte ^= (old ^ mixed) << shift;
    shift += step;
    if (coverage == end) {
      break;
    }
    if (shift >= 8) {
      *at++ = static_cast<uint8_t>(byte);
      byte = *at;
      shift &= 7;
    }
  }
  *at = static_cast<uint8_t>(byte);
}

}  // namespace inkcell::port::detail
