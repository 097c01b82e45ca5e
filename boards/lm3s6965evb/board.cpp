// Stellaris LM3S6965 evaluation board: UART 0, and an SSD0323 OLED on SPI.
#include "board.hpp"

#include "counter.hpp"
#include "display.hpp"
#include "inkcell/port/ssd0323.hpp"
#include "registers.hpp"
#include "systick.hpp"
#include "uart_pl011.hpp"

namespace inkcell {
namespace board {
namespace {

constexpr uintptr_t kPortA = 0x40004000;
constexpr uintptr_t kPortC = 0x40006000;
constexpr uintptr_t kPortD = 0x40007000;
constexpr uintptr_t kSpi = 0x40008000;  // PL022
constexpr uintptr_t kUart = 0x4000c000;
constexpr uintptr_t kSystemControl = 0x400fe000;

// Registers of a port; the address of the data register selects the pins.
constexpr uintptr_t kDirection = 0x400;
constexpr uintptr_t kAlternate = 0x420;
constexpr uintptr_t kDigital = 0x51c;

// Pins: clock, frame and data of the SPI on port A; low for commands and high
// for data on port C; the display's select on port D, high in the emulator.
constexpr uint32_t kSpiPins = 1 << 2 | 1 << 3 | 1 << 5;
constexpr uint32_t kDataPin = 1 << 7;
constexpr uint32_t kSelectPin = 1 << 0;

void set_bits(uintptr_t address, uint32_t bits) noexcept {
  reg(address) = reg(address) | bits;
}

void set_pin(uintptr_t gpio, uint32_t pin, bool high) noexcept {
  reg(gpio + (pin << 2)) = high ? pin : 0;
}

void make_output(uintptr_t gpio, uint32_t pin) noexcept {
  set_bits(gpio + kDirection, pin);
  set_bits(gpio + kDigital, pin);
}

// Sends bytes and discards received ones: the controller stops when the receive
// buffer is full.
void spi_send(const uint8_t* bytes, size_t count) noexcept {
  for (size_t i = 0; i < count; ++i) {
    while ((reg(kSpi + 0x0c) & 2) == 0) {  // transmit buffer full
    }
    reg(kSpi + 0x08) = bytes[i];
    while ((reg(kSpi + 0x0c) & 0x10) != 0) {  // busy
    }
    while ((reg(kSpi + 0x0c) & 4) != 0) {  // something received
      touch(kSpi + 0x08);
    }
  }
}

void send_command(void*, const uint8_t* bytes, size_t count) noexcept {
  set_pin(kPortC, kDataPin, false);
  spi_send(bytes, count);
}

void send_data(void*, const uint8_t* bytes, size_t count) noexcept {
  set_pin(kPortC, kDataPin, true);
  spi_send(bytes, count);
}

constexpr port::Ssd0323 kDisplay = {{nullptr, send_command, send_data},
                                    INKCELL_DISPLAY_WIDTH,
                                    INKCELL_DISPLAY_HEIGHT};

}  // namespace

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

bool display_init(port::PixelFormat format) noexcept {
  set_bits(kSystemControl + 0x104, 1 << 4);                    // SPI
  set_bits(kSystemControl + 0x108, 1 << 0 | 1 << 2 | 1 << 3);  // ports
  touch(kSystemControl + 0x108);  // the clocks need three cycles
  set_bits(kPortA + kAlternate, kSpiPins);
  set_bits(kPortA + kDigital, kSpiPins);
  make_output(kPortC, kDataPin);
  make_output(kPortD, kSelectPin);
  set_pin(kPortD, kSelectPin, true);
  reg(kSpi + 0x04) = 0;
  reg(kSpi + 0x10) = 50;    // clock divider
  reg(kSpi + 0x00) = 0xc7;  // 8 bits, clock idles high, second edge
  reg(kSpi + 0x04) = 2;     // enable
  port::init(kDisplay);
  return format == port::PixelFormat::grey4;
}

Status display_write(const Strip& strip) noexcept {
  return port::write(kDisplay, strip);
}

}  // namespace board
}  // namespace inkcell
