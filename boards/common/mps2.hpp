// What Arm's MPS2 boards share: CMSDK UART and CMSDK timer.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "registers.hpp"

namespace inkcell::board {

/// Enables the transmitter, and the timer as a free-running 32-bit counter.
inline void mps2_init(uintptr_t uart, uintptr_t timer) noexcept {
  reg(uart + 0x10) = 16;  // baud rate divider, the smallest
  reg(uart + 0x08) = 1;   // transmit
  reg(timer + 0x08) = 0xffffffff;
  reg(timer + 0x04) = 0xffffffff;
  reg(timer) = 1;
}

inline void mps2_write(uintptr_t uart, const char* text, size_t size) noexcept {
  for (size_t i = 0; i < size; ++i) {
    while ((reg(uart + 0x04) & 1) != 0) {  // buffer full
    }
    reg(uart) = static_cast<uint8_t>(text[i]);
  }
}

/// The timer counts down.
inline uint32_t mps2_ticks(uintptr_t timer) noexcept {
  return 0xffffffff - reg(timer + 0x04);
}

}  // namespace inkcell::board
