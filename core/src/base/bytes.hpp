// Little-endian numbers in ROM, read alike on every core.
#pragma once

#include <stdint.h>

#include "inkcell/assert.hpp"

namespace inkcell::detail {

// The format keeps u16 at even and u32 at fourfold offsets, and the reader
// checks the base, so these become single loads where the core is little
// endian. The compiler must not assume more than it is told here: Cortex-M0
// traps on anything unaligned. Inline at any level: a compiler finds out too
// late how short they are.
__attribute__((always_inline)) inline uint16_t load_u16(
    const uint8_t* at) noexcept {
  INKCELL_ASSERT(reinterpret_cast<uintptr_t>(at) % 2 == 0);
  const auto* p = static_cast<const uint8_t*>(__builtin_assume_aligned(at, 2));
  return static_cast<uint16_t>(p[0] | p[1] << 8);
}

__attribute__((always_inline)) inline int16_t load_i16(
    const uint8_t* at) noexcept {
  return static_cast<int16_t>(load_u16(at));
}

__attribute__((always_inline)) inline uint32_t load_u32(
    const uint8_t* at) noexcept {
  INKCELL_ASSERT(reinterpret_cast<uintptr_t>(at) % 4 == 0);
  const auto* p = static_cast<const uint8_t*>(__builtin_assume_aligned(at, 4));
  return static_cast<uint32_t>(p[0]) | static_cast<uint32_t>(p[1]) << 8 |
         static_cast<uint32_t>(p[2]) << 16 | static_cast<uint32_t>(p[3]) << 24;
}

// At any address: one load where the core has that.
__attribute__((always_inline)) inline uint32_t load_any_u32(
    const uint8_t* at) noexcept {
  return at[0] | uint32_t{at[1]} << 8 | uint32_t{at[2]} << 16 |
         uint32_t{at[3]} << 24;
}

}  // namespace inkcell::detail
