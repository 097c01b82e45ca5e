// The SSD0303's commands, and strips sent page by page.
#include "inkcell/port/ssd0303.hpp"

#include "bounds.hpp"

namespace inkcell {
namespace port {
namespace {

enum Command : uint8_t {
  kSetColumnLow = 0x00,   // | low nibble of the column
  kSetColumnHigh = 0x10,  // | high nibble of the column
  kSetStartLine = 0x40,   // | line
  kSegmentsNormal = 0xa0,
  kNormalDisplay = 0xa4,
  kNotInverse = 0xa6,
  kDisplayOff = 0xae,
  kDisplayOn = 0xaf,
  kSetPage = 0xb0,  // | page
  kScanNormal = 0xc0,
};

constexpr int32_t kColumns = 132;  // of the controller's memory [px]
constexpr int32_t kRows = 64;

}  // namespace

void init(const Ssd0303& display) noexcept {
  const uint8_t commands[] = {
      kDisplayOff,   kSegmentsNormal, kNormalDisplay, kNotInverse,
      kSetStartLine, kScanNormal,     kDisplayOn,
  };
  display.bus.command(display.bus.context, commands, sizeof commands);
}

Status write(const Ssd0303& display, const Strip& strip) noexcept {
  if (display.first_column + display.width > kColumns ||
      display.height > kRows) {
    return Status::bad_argument;
  }
  INKCELL_TRY(check_on_screen(strip, PixelFormat::mono_pages, display.width,
                              display.height));
  const int32_t column = display.first_column + strip.x0;
  const uint8_t* page = strip.pixels.data;
  for (int32_t y = 0; y < strip.height; y += 8, page += strip.stride) {
    const uint8_t address[] = {
        static_cast<uint8_t>(kSetPage | ((strip.y0 + y) / 8)),
        static_cast<uint8_t>(kSetColumnLow | (column & 15)),
        static_cast<uint8_t>(kSetColumnHigh | (column >> 4)),
    };
    display.bus.command(display.bus.context, address, sizeof address);
    display.bus.data(display.bus.context, page,
                     static_cast<size_t>(strip.width));
  }
  return Status::ok;
}

}  // namespace port
}  // namespace inkcell
