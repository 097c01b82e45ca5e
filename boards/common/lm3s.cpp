// UART 0 and the counter of the Stellaris boards.
#include "lm3s.hpp"

#include "board.hpp"
#include "counter.hpp"
#include "systick.hpp"
#include "uart_pl011.hpp"

namespace inkcell::board {

void init() noexcept {
  set_bits(kSystemControl + 0x104, 1);  // clock of the UART
  pl011_init(kUart);
  systick_init();
}

void console_write(const char* text, size_t size) noexcept {
  pl011_write(kUart, text, size);
}

uint32_t counter_ticks() noexcept {
  return systick_ticks();
}

}  // namespace inkcell::board
