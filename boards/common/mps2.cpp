// Arm's MPS2 boards: CMSDK UART 0 and CMSDK timer 0, at the addresses that the
// board's CMake file names.
#include "board.hpp"
#include "counter.hpp"
#include "registers.hpp"

namespace inkcell::board {
namespace {

constexpr uintptr_t kUart = INKCELL_UART;
constexpr uintptr_t kTimer = INKCELL_TIMER;

}  // namespace

// Enables the transmitter, and the timer as a free-running 32-bit counter.
void init() noexcept {
  reg(kUart + 0x10) = 16;  // baud rate divider, the smallest
  reg(kUart + 0x08) = 1;   // transmit
  reg(kTimer + 0x08) = 0xffffffff;
  reg(kTimer + 0x04) = 0xffffffff;
  reg(kTimer) = 1;
}

void console_write(const char* text, size_t size) noexcept {
  for (size_t i = 0; i < size; ++i) {
    while ((reg(kUart + 0x04) & 1) != 0) {  // buffer full
    }
    reg(kUart) = static_cast<uint8_t>(text[i]);
  }
}

// The timer counts down.
uint32_t counter_ticks() noexcept {
  return 0xffffffff - reg(kTimer + 0x04);
}

}  // namespace inkcell::board
