// The SysTick timer of Cortex-M as a 24-bit counter.
#pragma once

#include <stdint.h>

#include "registers.hpp"

namespace inkcell::board {

inline constexpr uintptr_t kSysTick = 0xe000e010;

/// Reads once: the first reload happens at the first tick.
inline void systick_init() noexcept {
  reg(kSysTick + 4) = 0xffffff;
  reg(kSysTick + 8) = 0;
  reg(kSysTick) = 5;  // enable, processor clock, no interrupt
  touch(kSysTick + 8);
}

/// The timer counts down.
inline uint32_t systick_ticks() noexcept {
  return 0xffffff - (reg(kSysTick + 8) & 0xffffff);
}

}  // namespace inkcell::board
