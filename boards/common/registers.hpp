// Access to memory-mapped registers by address.
#pragma once

#include <stdint.h>

namespace inkcell::board {

/// The register of type T (uint8_t, uint16_t, uint32_t) at `address`.
template <typename T = uint32_t>
inline volatile T& reg(uintptr_t address) noexcept {
  return *reinterpret_cast<volatile T*>(address);
}

/// Reads a register for its side effect. A discarded `reg(address)` would not:
/// GCC makes no access of a volatile reference that nobody uses.
inline void touch(uintptr_t address) noexcept {
  const uint32_t value = reg(address);
  static_cast<void>(value);
}

}  // namespace inkcell::board
