// The SH1106's commands, and strips sent page by page: it has no windows.
#include "inkcell/port/sh1106.hpp"

#include "bounds.hpp"
#include "oled_commands.hpp"
#include "send_pages.hpp"

namespace inkcell::port {
namespace {

enum Command : uint8_t {
  kSetStartLine = 0x40,  // | line
  kSegmentsNormal = 0xa0,
  kSegmentsReverse = 0xa1,
  kNormalDisplay = 0xa4,
  kNotInverse = 0xa6,
  kSetMultiplex = 0xa8,  // rows - 1
  kSetConverter = 0xad,
  kScanNormal = 0xc0,
  kScanReverse = 0xc8,
  kSetOffset = 0xd3,
};

// Parameters.
constexpr uint8_t kConverterOff = 0x8a;
constexpr uint8_t kConverterOn = 0x8b;

constexpr int32_t kColumns = 132;  // of the controller's memory [px]
constexpr int32_t kRows = 64;

Status check(const Sh1106& display) noexcept {
  return display.width == 0 ||
                 display.first_column + display.width > kColumns ||
                 display.height == 0 || display.height > kRows ||
                 display.height % 8 != 0
             ? Status::bad_argument
             : Status::ok;
}

}  // namespace

Status init(const Sh1106& display) noexcept {
  INKCELL_TRY(check(display));
  const uint8_t commands[] = {
      kDisplayOff,
      display.turned ? kSegmentsReverse : kSegmentsNormal,
      display.turned ? kScanReverse : kScanNormal,
      kSetStartLine,
      kSetOffset,
      0,
      kSetMultiplex,
      static_cast<uint8_t>(display.height - 1),
      kSetConverter,
      display.converter ? kConverterOn : kConverterOff,
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

Status write(const Sh1106& display, const Strip& strip) noexcept {
  INKCELL_TRY(check(display));
  INKCELL_TRY(
      check_on_screen(strip, Sh1106::kFormat, display.width, display.height));
  send_pages(display.bus,
             display.turned ? kColumns - display.first_column - display.width
                            : display.first_column,
             strip);
  return Status::ok;
}

void sleep(const Sh1106& display) noexcept {
  send_power(display.bus, kDisplayOff);
}

void wake(const Sh1106& display) noexcept {
  send_power(display.bus, kDisplayOn);
}

void set_contrast(const Sh1106& display, uint8_t contrast) noexcept {
  send_contrast(display.bus, contrast);
}

}  // namespace inkcell::port
