// BBC micro:bit: UART and timer 0 of the nRF51822.
#include "board.hpp"

#include "counter.hpp"
#include "registers.hpp"

namespace inkcell::board {
namespace {

constexpr uintptr_t kUart = 0x40002000;
constexpr uintptr_t kUartStartTransmit = kUart + 0x008;
constexpr uintptr_t kUartTransmitted = kUart + 0x11c;
constexpr uintptr_t kUartEnable = kUart + 0x500;
constexpr uintptr_t kUartData = kUart + 0x51c;

constexpr uintptr_t kTimer = 0x40008000;
constexpr uintptr_t kTimerStart = kTimer;
constexpr uintptr_t kTimerCapture = kTimer + 0x040;
constexpr uintptr_t kTimerWidth = kTimer + 0x508;
constexpr uintptr_t kTimerPrescaler = kTimer + 0x510;
constexpr uintptr_t kTimerCaptured = kTimer + 0x540;

}  // namespace

void init() noexcept {
  reg(kUartEnable) = 4;
  reg(kUartStartTransmit) = 1;
  reg(kTimerWidth) = 3;  // 32 bits
  reg(kTimerPrescaler) = 0;
  reg(kTimerStart) = 1;
}

void console_write(const char* text, size_t size) noexcept {
  for (size_t i = 0; i < size; ++i) {
    reg(kUartTransmitted) = 0;
    reg(kUartData) = static_cast<uint8_t>(text[i]);
    while (reg(kUartTransmitted) == 0) {
    }
  }
}

uint32_t counter_ticks() noexcept {
  reg(kTimerCapture) = 1;
  return reg(kTimerCaptured);
}

}  // namespace inkcell::board
