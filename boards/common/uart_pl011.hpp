// The PL011 UART (lm3s*, versatilepb).
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "registers.hpp"

namespace inkcell::board {

inline void pl011_init(uintptr_t base) noexcept {
  reg(base + 0x30) = 0x301;  // enable, transmit, receive
}

inline void pl011_write(uintptr_t base,
                        const char* text,
                        size_t size) noexcept {
  for (size_t i = 0; i < size; ++i) {
    while ((reg(base + 0x18) & 0x20) != 0) {  // transmit FIFO full
    }
    reg(base) = static_cast<uint8_t>(text[i]);
  }
}

inline char pl011_read(uintptr_t base) noexcept {
  while ((reg(base + 0x18) & 0x10) != 0) {  // nothing received
  }
  return static_cast<char>(reg(base) & 0xff);
}

}  // namespace inkcell::board
