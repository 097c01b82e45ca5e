// Arm MPS2 with image AN386: UART 0 and timer 0.
#include "board.hpp"

#include "counter.hpp"
#include "mps2.hpp"

namespace inkcell::board {
namespace {

constexpr uintptr_t kUart = 0x40004000;
constexpr uintptr_t kTimer = 0x40000000;

}  // namespace

void init() noexcept {
  mps2_init(kUart, kTimer);
}

void console_write(const char* text, size_t size) noexcept {
  mps2_write(kUart, text, size);
}

uint32_t counter_ticks() noexcept {
  return mps2_ticks(kTimer);
}

}  // namespace inkcell::board
