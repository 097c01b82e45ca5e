// Measures the stack that a piece of code needs.
#pragma once

#include <stddef.h>
#include <stdint.h>

extern "C" {
// Set by flash_and_ram.ld.
extern uint32_t inkcell_stack_limit[];
extern uint32_t inkcell_stack_top[];
}

namespace inkcell::board {

inline uintptr_t stack_pointer() noexcept {
  uintptr_t value;
#if defined(__riscv)
  asm volatile("mv %0, sp" : "=r"(value));
#else
  asm volatile("mov %0, sp" : "=r"(value));
#endif
  return value;
}

/// Fills the free part of the stack with a pattern.
void paint_stack() noexcept;

/// The lowest address at which the pattern is overwritten.
uintptr_t lowest_stack_used() noexcept;

/// The greatest stack use of `work()`, with its return address if it is called.
/// [bytes] A multiple of 4.
template <typename Work>
[[gnu::noinline]] size_t count_stack(const Work& work) noexcept {
  const uintptr_t here = stack_pointer();
  paint_stack();
  work();
  return here - lowest_stack_used();
}

}  // namespace inkcell::board
