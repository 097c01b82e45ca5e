// The functions of your_board.hpp, for you to fill in.
#include "your_board.hpp"

void write_command(void*, const uint8_t*, size_t) {}
void write_data(void*, const uint8_t*, size_t) {}

// Without DMA: write_data(), and wait_sent() stays empty.
void start_data(void*, const uint8_t*, size_t) {}
void wait_sent(void*) {}

void write_i2c(void*, uint8_t, const uint8_t*, size_t) {}

void pulse_reset(void*) {}
void wait_ms(void*, uint32_t) {}
void wait_idle(void*) {}

const char* read_temperature() {
  return "21.5";
}
uint32_t read_minutes() {
  return 12 * 60 + 59;
}
