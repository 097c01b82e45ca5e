// Sino Wealth SH1106: OLED displays with 1-bit pixels, I2C or SPI.
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"
#include "inkcell/port/oled_panel.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// A display of up to 132 x 64 pixels. Its pixels are those of
/// PixelFormat::mono_pages.
/// sleep(), wake() and set_contrast() stand in oled_panel.hpp.
struct Sh1106 {
  static constexpr PixelFormat kFormat = PixelFormat::mono_pages;
  static constexpr uint8_t kContrastShift = 0;

  DisplayBus bus;
  uint8_t width = 128;       // [px]
  uint8_t height = 64;       // [px], a multiple of 8
  uint8_t first_column = 2;  // the lowest segment output in use
  /// Turns the picture by 180 degrees. Most modules then have their connector
  /// at the top.
  bool turned = false;
  /// The controller's DC-DC converter supplies the panel.
  bool converter = true;
};

/// Pulses the reset line if there is one, sets what write() relies on, and
/// switches the panel on. The display's memory is unchanged. The board sends
/// clock and pump voltage through the same bus.
///
/// bad_argument: a size is out of range, or the display is larger than the
/// controller's memory of 132 x 64. Nothing is sent then.
Status init(const Sh1106& display) noexcept;

/// Sends a strip to its place on the screen, page by page.
///
/// bad_argument: as init(); or the strip is not on the screen, its top or
/// height is not a multiple of 8, or its stride is shorter than a page.
/// buffer_small: it has fewer pixels than its pages need. Nothing is sent then.
Status write(const Sh1106& display, const Strip& strip) noexcept;

}  // namespace inkcell::port
