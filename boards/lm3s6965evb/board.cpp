// Stellaris LM3S6965 evaluation board: an SSD0323 OLED and an SD card, both on
// the same SPI.
#include "card.hpp"
#include "display.hpp"
#include "inkcell/port/ssd0323.hpp"
#include "lm3s.hpp"
#include "sd_card.hpp"

namespace inkcell::board {
namespace {

constexpr uintptr_t kPortA = 0x40004000;
constexpr uintptr_t kPortC = 0x40006000;
constexpr uintptr_t kPortD = 0x40007000;
constexpr uintptr_t kSpi = 0x40008000;  // PL022

// Of a port; the address of its data register selects the pins.
constexpr uintptr_t kDirection = 0x400;

// Pins: clock, frame and data of the SPI on port A, the frame selects the
// display; low for commands and high for data on port C; the card's select on
// port D, which is low for the card. The emulator takes its high for the
// display's select.
constexpr uint32_t kFramePin = 1 << 3;
constexpr uint32_t kSpiPins = 1 << 2 | 1 << 4 | 1 << 5 | kFramePin;
constexpr uint32_t kDataPin = 1 << 7;
constexpr uint32_t kCardPin = 1 << 0;

// Dividers of 12.5 MHz: for a card that starts, 400 kHz at most; and for the
// display, 4 MHz at most.
constexpr uint32_t kSlow = 50;
constexpr uint32_t kFast = 4;

void set_pin(uintptr_t gpio, uint32_t pin, bool high) noexcept {
  reg(gpio + (pin << 2)) = high ? pin : 0;
}

void make_output(uintptr_t gpio, uint32_t pin) noexcept {
  set_bits(gpio + kDirection, pin);
  set_bits(gpio + kDigital, pin);
}

// Each byte sent is one received: the controller stops when the receive buffer
// is full.
uint8_t spi_exchange(uint8_t sent) noexcept {
  reg(kSpi + 0x08) = sent;
  while ((reg(kSpi + 0x0c) & 4) == 0) {  // nothing received
  }
  return static_cast<uint8_t>(reg(kSpi + 0x08));
}

void spi_send(const uint8_t* bytes, size_t count) noexcept {
  for (size_t i = 0; i < count; ++i) {
    static_cast<void>(spi_exchange(bytes[i]));
  }
}

void spi_start(uint32_t divider) noexcept {
  reg(kSpi + 0x04) = 0;
  reg(kSpi + 0x10) = divider;
  reg(kSpi + 0x00) = 0xc7;  // 8 bits, clock idles high, second edge
  reg(kSpi + 0x04) = 2;     // enable
}

// Without a card the frame of the SPI selects the display.
void select_card(bool is_selected) noexcept {
  const uint32_t pins = reg(kPortA + kAlternate) & ~kFramePin;
  reg(kPortA + kAlternate) = is_selected ? pins : pins | kFramePin;
  set_pin(kPortD, kCardPin, !is_selected);
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

SdCard card;

}  // namespace

bool display_init(port::PixelFormat format) noexcept {
  set_bits(kSystemControl + 0x104, 1 << 4);                    // SPI
  set_bits(kSystemControl + 0x108, 1 << 0 | 1 << 2 | 1 << 3);  // ports
  touch(kSystemControl + 0x108);  // the clocks need three cycles
  set_bits(kPortA + kAlternate, kSpiPins);
  set_bits(kPortA + kDigital, kSpiPins);
  // High while it is not the frame.
  set_bits(kPortA + kDirection, kFramePin);
  set_pin(kPortA, kFramePin, true);
  make_output(kPortC, kDataPin);
  make_output(kPortD, kCardPin);
  select_card(false);
  spi_start(kFast);
  port::init(kDisplay);
  return format == port::PixelFormat::grey4;
}

Status display_write(const Strip& strip) noexcept {
  return port::write(kDisplay, strip);
}

Status card_init() noexcept {
  spi_start(kSlow);
  const Status status = card.open({spi_exchange, select_card});
  spi_start(kFast);
  return status;
}

bool card_read(void*,
               uint32_t offset,
               uint8_t* bytes,
               uint32_t count) noexcept {
  for (uint32_t at = 0; at != count; at += SdCard::kBlockBytes) {
    if (card.read_block((offset + at) / SdCard::kBlockBytes, bytes + at) !=
        Status::ok) {
      return false;
    }
  }
  return true;
}

}  // namespace inkcell::board
