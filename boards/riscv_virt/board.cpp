// QEMU's RISC-V virt machine: 16550 UART, memory protection, and a PCI display.
#include "board.hpp"

#include "counter.hpp"
#include "display.hpp"
#include "inkcell/port/framebuffer.hpp"
#include "registers.hpp"
#include "serial.hpp"

namespace inkcell::board {
namespace {

constexpr uintptr_t kUart = 0x10000000;

// PCI: configuration space, and the address range of its devices.
constexpr uintptr_t kPci = 0x30000000;
constexpr uintptr_t kPciDevices = 32;
constexpr uint32_t kDisplayId = 0x11111234;
constexpr uintptr_t kFramebuffer = 0x40000000;
constexpr uintptr_t kDisplay = 0x42000000;
constexpr uintptr_t kDisplayAttributes = kDisplay + 0x400;

// Registers of the display.
enum DisplayRegister : uintptr_t {
  kXResolution = 1,
  kYResolution = 2,
  kBitsPerPixel = 3,
  kEnable = 4,
  kVirtualWidth = 6,
  kVirtualHeight = 7,
  kXOffset = 8,
  kYOffset = 9,
};

void set_display(DisplayRegister index, uint32_t value) noexcept {
  reg<uint16_t>(kDisplay + 0x500 + 2 * index) = static_cast<uint16_t>(value);
}

// The configuration space of the display, 0 if there is none.
uintptr_t find_display() noexcept {
  for (uintptr_t device = 0; device < kPciDevices; ++device) {
    const uintptr_t configuration = kPci + (device << 15);
    if (reg(configuration) == kDisplayId) {
      return configuration;
    }
  }
  return 0;
}

// The choice of display_init().
port::Framebuffer display;

// Makes the image read-only permanently. Also catches a stack that overflows
// from RAM into the image. The region is aligned, and its size a power of two.
void protect_image() noexcept {
  constexpr uint32_t kBase = 0x80000000;
  constexpr uint32_t kSize = 4 << 20;
  const uint32_t region = (kBase >> 2) | ((kSize >> 3) - 1);
  const uint32_t locked_read_execute = 0x9d;
  asm volatile("csrw pmpaddr0, %0" : : "r"(region));
  asm volatile("csrw pmpcfg0, %0" : : "r"(locked_read_execute));
}

}  // namespace

void init() noexcept {
  protect_image();
}

void console_write(const char* text, size_t size) noexcept {
  for (size_t i = 0; i < size; ++i) {
    while ((reg<uint8_t>(kUart + 5) & 0x20) == 0) {  // transmitter busy
    }
    reg<uint8_t>(kUart) = static_cast<uint8_t>(text[i]);
  }
}

char console_read() noexcept {
  while ((reg<uint8_t>(kUart + 5) & 1) == 0) {  // nothing received
  }
  return static_cast<char>(reg<uint8_t>(kUart));
}

uint32_t counter_ticks() noexcept {
  uint32_t value;
  asm volatile("csrr %0, minstret" : "=r"(value));
  return value;
}

bool display_init(port::PixelFormat format) noexcept {
  const uintptr_t configuration = find_display();
  if (configuration == 0) {
    return false;
  }
  reg(configuration + 0x10) = kFramebuffer;
  reg(configuration + 0x18) = kDisplay;
  reg<uint16_t>(configuration + 0x04) = 2;  // answer to memory accesses

  set_display(kEnable, 0);
  set_display(kXResolution, INKCELL_DISPLAY_WIDTH);
  set_display(kYResolution, INKCELL_DISPLAY_HEIGHT);
  set_display(kBitsPerPixel,
              static_cast<uint32_t>(port::bits_per_pixel(format)));
  set_display(kVirtualWidth, INKCELL_DISPLAY_WIDTH);
  set_display(kVirtualHeight, INKCELL_DISPLAY_HEIGHT);
  set_display(kXOffset, 0);
  set_display(kYOffset, 0);
  set_display(kEnable, 0x41);               // linear framebuffer
  reg<uint8_t>(kDisplayAttributes) = 0x20;  // VGA only: unblank

  constexpr int32_t kWidth = INKCELL_DISPLAY_WIDTH;
  constexpr int32_t kHeight = INKCELL_DISPLAY_HEIGHT;
  display.format = format;
  display.width = kWidth;
  display.height = kHeight;
  display.stride = port::stride_bytes(format, kWidth);
  display.pixels = {reinterpret_cast<uint8_t*>(kFramebuffer),
                    port::strip_bytes(format, kWidth, kHeight)};
  return format == port::PixelFormat::xrgb8888 ||
         format == port::PixelFormat::rgb565;
}

Status display_write(const Strip& strip) noexcept {
  return port::write(display, strip);
}

}  // namespace inkcell::board
