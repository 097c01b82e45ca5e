// What the drivers of the SSD1306 and the SH1106 share.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/port/oled_panel.hpp"
#include "inkcell/status.hpp"

namespace inkcell::port {

/// bad_argument: the display has no size, or is not within `columns` x 64 px of
/// memory.
template <typename Display>
Status check_size(const Display& display,
                  int32_t columns,
                  int32_t least_rows) noexcept {
  return display.width == 0 || display.first_column + display.width > columns ||
                 display.height < least_rows || display.height > 64 ||
                 display.height % 8 != 0
             ? Status::bad_argument
             : Status::ok;
}

/// The column of the memory that is the left one of the screen.
template <typename Display>
int32_t left_column(const Display& display, int32_t columns) noexcept {
  return display.turned ? columns - display.first_column - display.width
                        : display.first_column;
}

/// Resets the controller, sets both its mounting and what is its own, and
/// switches the panel on.
template <typename Display, size_t kCount>
void start(const Display& display, const uint8_t (&own)[kCount]) noexcept {
  enum Command : uint8_t {
    kSetStartLine = 0x40,  // | line
    kSegmentsNormal = 0xa0,
    kSegmentsReverse = 0xa1,
    kNormalDisplay = 0xa4,
    kNotInverse = 0xa6,
    kSetMultiplex = 0xa8,  // rows - 1
    kScanNormal = 0xc0,
    kScanReverse = 0xc8,
    kSetOffset = 0xd3,
  };
  const uint8_t mounting[] = {
      detail::kOledOff,
      display.turned ? kSegmentsReverse : kSegmentsNormal,
      display.turned ? kScanReverse : kScanNormal,
      kSetStartLine,
      kSetOffset,
      0,
      kSetMultiplex,
      static_cast<uint8_t>(display.height - 1),
      kNormalDisplay,
      kNotInverse,
  };
  const DisplayBus& bus = display.bus;
  if (bus.reset != nullptr) {
    bus.reset(bus.context);
  }
  bus.command(bus.context, mounting, sizeof mounting);
  bus.command(bus.context, own, kCount);
  bus.command(bus.context, &detail::kOledOn, 1);
}

}  // namespace inkcell::port
