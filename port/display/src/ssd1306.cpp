// The SSD1306's commands (data sheet Rev 1.1), and strips sent as windows of
// its memory.
#include "inkcell/port/ssd1306.hpp"

#include "bounds.hpp"
#include "oled_commands.hpp"
#include "send_pixels.hpp"

namespace inkcell::port {
namespace {

enum Command : uint8_t {
  kSetAddressing = 0x20,  // mode
  kSetColumns = 0x21,     // first, last
  kSetPages = 0x22,       // first, last
  kSetStartLine = 0x40,   // | line
  kSetChargePump = 0x8d,
  kSegmentsNormal = 0xa0,
  kSegmentsReverse = 0xa1,
  kNormalDisplay = 0xa4,
  kNotInverse = 0xa6,
  kSetMultiplex = 0xa8,  // rows - 1
  kScanNormal = 0xc0,
  kScanReverse = 0xc8,
  kSetOffset = 0xd3,
  kSetRowPins = 0xda,
};

// Parameters.
constexpr uint8_t kHorizontal = 0x00;  // to the right, then to the next page
constexpr uint8_t kPumpOff = 0x10;
constexpr uint8_t kPumpOn = 0x14;
constexpr uint8_t kSequential = 0x02;
constexpr uint8_t kAlternating = 0x12;

constexpr int32_t kColumns = 128;  // of the controller's memory [px]
constexpr int32_t kRows = 64;
constexpr int32_t kMinRows = 16;  // of the multiplex ratio

Status check(const Ssd1306& display) noexcept {
  return display.width == 0 ||
                 display.first_column + display.width > kColumns ||
                 display.height < kMinRows || display.height > kRows ||
                 display.height % 8 != 0
             ? Status::bad_argument
             : Status::ok;
}

}  // namespace

Status init(const Ssd1306& display) noexcept {
  INKCELL_TRY(check(display));
  const uint8_t commands[] = {
      kDisplayOff,
      kSetAddressing,
      kHorizontal,
      display.turned ? kSegmentsReverse : kSegmentsNormal,
      display.turned ? kScanReverse : kScanNormal,
      kSetStartLine,
      kSetOffset,
      0,
      kSetMultiplex,
      static_cast<uint8_t>(display.height - 1),
      kSetRowPins,
      display.sequential_rows ? kSequential : kAlternating,
      kSetChargePump,
      display.external_supply ? kPumpOff : kPumpOn,
      kNormalDisplay,
      kNotInverse,
      kDisplayOn,
  };
  if (display.bus.reset != nullptr) {
    display.bus.reset(display.bus.context);
  }
  display.bus.command(display.bus.context, commands, sizeof commands);
  return Status::ok;
}

Status write(const Ssd1306& display, const Strip& strip) noexcept {
  INKCELL_TRY(check(display));
  INKCELL_TRY(
      check_on_screen(strip, Ssd1306::kFormat, display.width, display.height));
  const int32_t left = display.turned
                           ? kColumns - display.first_column - display.width
                           : display.first_column;
  const uint8_t window[] = {
      kSetColumns,
      static_cast<uint8_t>(left + strip.x0),
      static_cast<uint8_t>(left + strip.x0 + strip.width - 1),
      kSetPages,
      static_cast<uint8_t>(strip.y0 / 8),
      static_cast<uint8_t>((strip.y0 + strip.height) / 8 - 1),
  };
  display.bus.command(display.bus.context, window, sizeof window);
  send_pixels(display.bus, strip, Ssd1306::kFormat);
  return Status::ok;
}

void sleep(const Ssd1306& display) noexcept {
  send_power(display.bus, kDisplayOff);
}

void wake(const Ssd1306& display) noexcept {
  send_power(display.bus, kDisplayOn);
}

void set_contrast(const Ssd1306& display, uint8_t contrast) noexcept {
  send_contrast(display.bus, contrast);
}

}  // namespace inkcell::port
