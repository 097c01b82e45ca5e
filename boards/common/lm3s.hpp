// Registers that the Stellaris boards share.
#pragma once

#include <stdint.h>

#include "registers.hpp"

namespace inkcell::board {

inline constexpr uintptr_t kUart = 0x4000c000;
inline constexpr uintptr_t kSystemControl = 0x400fe000;

// Registers of a port.
inline constexpr uintptr_t kAlternate = 0x420;
inline constexpr uintptr_t kDigital = 0x51c;

inline void set_bits(uintptr_t address, uint32_t bits) noexcept {
  reg(address) = reg(address) | bits;
}

}  // namespace inkcell::board
