// Shared by the start-up code of all architectures.
#pragma once

#include <stdint.h>

extern "C" {

/// Initialises .data, .bss, constructors and the board, calls main() and exits.
/// The stack pointer must be set.
[[noreturn]] void inkcell_start() noexcept;

/// Reports a fault at `address` (0: unknown) and exits. Runs on a fresh stack.
[[noreturn]] void inkcell_fault(uint32_t address) noexcept;
}
