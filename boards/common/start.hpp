// What the start-up code of each architecture has in common with the rest.
#pragma once

#include <stdint.h>

extern "C" {

/// Fills .data and .bss, runs constructors, initialises the board, calls main()
/// and exits. The stack pointer is set.
[[noreturn]] void inkcell_start() noexcept;

/// Reports a fault at `address` (0: unknown) and exits. Runs on a fresh stack.
[[noreturn]] void inkcell_fault(uint32_t address) noexcept;
}
