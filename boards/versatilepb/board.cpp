// Arm Versatile/PB: UART 0, and a PL110 that shows a framebuffer.
#include "board.hpp"

#include "display.hpp"
#include "inkcell/port/framebuffer.hpp"
#include "registers.hpp"
#include "serial.hpp"
#include "uart_pl011.hpp"

namespace inkcell::board {
namespace {

constexpr uintptr_t kUart = 0x101f1000;
constexpr uintptr_t kLcd = 0x10120000;
constexpr uintptr_t kLcdFormat = 0x10000050;  // of the board's own registers

constexpr uint32_t kWidth = INKCELL_DISPLAY_WIDTH;  // a multiple of 16
constexpr uint32_t kHeight = INKCELL_DISPLAY_HEIGHT;
constexpr size_t kPixelBytes = 2;

alignas(8) uint8_t pixels[kWidth * kHeight * kPixelBytes];

constexpr port::Framebuffer kDisplay = {pixels, port::PixelFormat::rgb565,
                                        kWidth, kHeight, kWidth* kPixelBytes};

}  // namespace

void init() noexcept {
  pl011_init(kUart);
}

void console_write(const char* text, size_t size) noexcept {
  pl011_write(kUart, text, size);
}

char console_read() noexcept {
  return pl011_read(kUart);
}

bool display_init(port::PixelFormat format) noexcept {
  reg(kLcd + 0x00) = (kWidth / 16 - 1) << 2;
  reg(kLcd + 0x04) = kHeight - 1;
  reg(kLcd + 0x10) = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(pixels));
  reg(kLcdFormat) = 2;  // 5-6-5 bits, red in the high ones
  // Enable, 16 bits a pixel, TFT, red and blue swapped back, power.
  reg(kLcd + 0x18) = 1 | 4 << 1 | 1 << 5 | 1 << 8 | 1 << 11;
  return format == kDisplay.format;
}

Status display_write(const Strip& strip) noexcept {
  return port::write(kDisplay, strip);
}

}  // namespace inkcell::board
