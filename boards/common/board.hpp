// What every board offers: a console and an exit code. A counter is in
// counter.hpp, a display in display.hpp, files in semihosting.hpp.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace inkcell {
namespace board {

/// Switches clocks, UART and counter on. Start-up calls it before main(); a
/// program never does.
void init() noexcept;

/// Sends `size` characters to the board's UART and waits until it took them.
void console_write(const char* text, size_t size) noexcept;

/// Ends the program: in an emulator with `code` as its exit code (0..255), on
/// hardware without a debugger by standing still.
[[noreturn]] void exit(int code) noexcept;

/// The exit code of a program that ran into a fault: an access that the board
/// refuses, an unaligned one where the core can refuse it, a division by zero,
/// an undefined instruction, an interrupt that nobody asked for.
inline constexpr int kFaultExitCode = 70;

/// console_write() of a string that ends with a zero, and of a number.
void print(const char* text) noexcept;
void print_decimal(uint32_t value) noexcept;
void print_hex(uint32_t value) noexcept;

}  // namespace board
}  // namespace inkcell
