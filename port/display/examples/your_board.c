// The functions of your_board.h, for you to fill in.
#include "your_board.h"

void write_command(void* context, const uint8_t* bytes, size_t count) {
  (void)context, (void)bytes, (void)count;
}
void write_data(void* context, const uint8_t* bytes, size_t count) {
  (void)context, (void)bytes, (void)count;
}

// Without DMA: write_data(), and wait_sent() stays empty.
void start_data(void* context, const uint8_t* bytes, size_t count) {
  (void)context, (void)bytes, (void)count;
}
void wait_sent(void* context) {
  (void)context;
}

void write_i2c(void* context,
               uint8_t address,
               const uint8_t* bytes,
               size_t count) {
  (void)context, (void)address, (void)bytes, (void)count;
}

void pulse_reset(void* context) {
  (void)context;
}
void wait_ms(void* context, uint32_t ms) {
  (void)context, (void)ms;
}
void wait_idle(void* context) {
  (void)context;
}

const char* read_temperature(void) {
  return "21.5";
}
uint32_t read_minutes(void) {
  return 12 * 60 + 59;
}
uint32_t read_percent(void) {
  return 71;
}
