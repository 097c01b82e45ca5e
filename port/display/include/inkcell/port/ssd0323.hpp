// Solomon SSD0323: OLED displays with 16 levels of grey.
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"
#include "inkcell/port/oled_panel.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// A display of up to 128 x 80 pixels, usually 128 x 64. Its pixels are those
/// of PixelFormat::grey4 with BitOrder::high_left.
/// sleep(), wake() and set_contrast() stand in oled_panel.hpp.
struct Ssd0323 {
  static constexpr PixelFormat kFormat = PixelFormat::grey4;
  static constexpr uint8_t kContrastShift = 1;  // it has 7 bits

  DisplayBus bus;
  uint8_t width = 128;  // [px], even
  uint8_t height = 64;  // [px]
};

/// Sets the addressing that write() relies on, and switches the panel on. The
/// display's memory is unchanged.
///
/// The board sends what depends on panel and wiring through the same bus: DC-DC
/// converter, clock, grey table, and after init() the remap for a panel mounted
/// upside down.
void init(const Ssd0323& display) noexcept;

/// Sends a strip to its place on the screen.
///
/// bad_argument: the display is larger than the controller's memory, the strip
/// does not lie on the screen, its left edge or width is odd, or its stride is
/// shorter than a row. buffer_small: it has fewer pixels than its rows need.
/// Nothing is sent then.
Status write(const Ssd0323& display, const Strip& strip) noexcept;

}  // namespace inkcell::port
