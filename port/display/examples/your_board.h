// What the examples need of your board. your_board.c has these functions,
// empty: fill in those that your display needs. `context` is
// DisplayBus::context or the like, which the examples leave null.
#pragma once

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// SPI, the display's CS low: D/C is low for commands and high for data. Both
/// return when the bytes are sent.
void write_command(void* context, const uint8_t* bytes, size_t count);
void write_data(void* context, const uint8_t* bytes, size_t count);

/// Starts to send data by DMA and returns. Until wait_sent() returns, or one of
/// the functions above is called, `bytes` do not change.
void start_data(void* context, const uint8_t* bytes, size_t count);
void wait_sent(void* context);

/// I2C: start condition, the 7-bit address, `count` bytes, stop condition.
void write_i2c(void* context,
               uint8_t address,
               const uint8_t* bytes,
               size_t count);

/// The display's reset line: low for 10 ms, then high for 10 ms.
void pulse_reset(void* context);
void wait_ms(void* context, uint32_t ms);

/// Returns when the BUSY line of e-paper says that the display is idle.
void wait_idle(void* context);

/// What the examples show: a temperature as text, "21.5"; minutes since
/// midnight; a level, 0 to 100.
const char* read_temperature(void);
uint32_t read_minutes(void);
uint32_t read_percent(void);

#ifdef __cplusplus
}
#endif
