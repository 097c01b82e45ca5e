// The functions of every board: a console and an exit code. A counter is in
// counter.hpp, a display in display.hpp, files in semihosting.hpp.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace inkcell::board {

/// Switches clocks, UART and counter on. Called by the start-up code only.
void init() noexcept;

/// Sends `size` characters to the board's UART and waits until it accepts them.
void console_write(const char* text, size_t size) noexcept;

/// Ends the program: in an emulator with `code` as its exit code (0..255), on
/// hardware without a debugger in an endless loop.
[[noreturn]] void exit(int code) noexcept;

/// The exit code after a fault: a refused access, an unaligned one if the core
/// can refuse it, a division by zero, an undefined instruction, an unexpected
/// interrupt.
inline constexpr int kFaultExitCode = 70;

/// console_write() of a zero-terminated string, and of a number.
void print(const char* text) noexcept;
void print_decimal(uint32_t value) noexcept;
void print_hex(uint32_t value) noexcept;

}  // namespace inkcell::board
