// Stellaris LM3S811 evaluation board: an SSD0303 OLED on I2C.
#include "display.hpp"
#include "inkcell/port/ssd0303.hpp"
#include "lm3s.hpp"

namespace inkcell::board {
namespace {

constexpr uintptr_t kPortB = 0x40005000;
constexpr uintptr_t kI2c = 0x40020000;
constexpr uint32_t kI2cPins = 1 << 2 | 1 << 3;

constexpr uint32_t kDisplayAddress = 0x3d;
constexpr uint8_t kControlCommand = 0x80;
constexpr uint8_t kControlData = 0x40;

enum Transfer : uint32_t { kRun = 1, kStart = 2, kStop = 4 };

void i2c_send(uint8_t byte, uint32_t transfer) noexcept {
  reg(kI2c + 0x08) = byte;
  reg(kI2c + 0x04) = transfer;
  while ((reg(kI2c + 0x04) & 1) != 0) {  // busy
  }
}

// One transfer for each byte: the controller takes one command in a transfer.
void send_command(void*, const uint8_t* bytes, size_t count) noexcept {
  for (size_t i = 0; i < count; ++i) {
    i2c_send(kControlCommand, kStart | kRun);
    i2c_send(bytes[i], kRun | kStop);
  }
}

void send_data(void*, const uint8_t* bytes, size_t count) noexcept {
  i2c_send(kControlData, kStart | kRun);
  for (size_t i = 0; i < count; ++i) {
    i2c_send(bytes[i], i + 1 == count ? kRun | kStop : kRun);
  }
}

// The panel shows the columns from 36 on.
constexpr port::Ssd0303 kDisplay = {{nullptr, send_command, send_data},
                                    INKCELL_DISPLAY_WIDTH,
                                    INKCELL_DISPLAY_HEIGHT,
                                    36};

}  // namespace

bool display_init(port::PixelFormat format) noexcept {
  set_bits(kSystemControl + 0x104, 1 << 12);  // I2C
  set_bits(kSystemControl + 0x108, 1 << 1);   // port B
  touch(kSystemControl + 0x108);              // the clocks need three cycles
  set_bits(kPortB + kAlternate, kI2cPins);
  set_bits(kPortB + kDigital, kI2cPins);
  reg(kI2c + 0x20) = 0x10;  // master
  reg(kI2c + 0x0c) = 24;    // clock divider
  reg(kI2c + 0x00) = kDisplayAddress << 1;
  port::init(kDisplay);
  return format == port::PixelFormat::mono_pages;
}

Status display_write(const Strip& strip) noexcept {
  return port::write(kDisplay, strip);
}

}  // namespace inkcell::board
