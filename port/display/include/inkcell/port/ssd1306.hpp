// Solomon SSD1306: OLED displays with 1-bit pixels, I2C or SPI.
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"
#include "inkcell/port/oled_panel.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// A display of up to 128 x 64 pixels. Its pixels are those of
/// PixelFormat::mono_pages.
/// sleep(), wake() and set_contrast() stand in oled_panel.hpp.
struct Ssd1306 {
  static constexpr PixelFormat kFormat = PixelFormat::mono_pages;
  static constexpr uint8_t kContrastShift = 0;

  DisplayBus bus;
  uint8_t width = 128;       // [px]
  uint8_t height = 64;       // [px], a multiple of 8, 16 to 64
  uint8_t first_column = 0;  // the lowest segment output in use
  /// Turns the picture by 180 degrees. Most modules then have their connector
  /// at the top.
  bool turned = false;
  /// The rows are wired in order, as on panels of 128 x 32. On 128 x 64 they
  /// alternate between both halves.
  bool sequential_rows = false;
  /// The panel's VCC pin has a supply of 7 to 15 V. Else the controller's
  /// charge pump supplies it.
  bool external_supply = false;
};

/// Pulses the reset line if there is one, sets what write() relies on, and
/// switches the panel on. The display's memory is unchanged. The board sends
/// clock and pre-charge through the same bus.
///
/// bad_argument: a size is out of range, or the display is larger than the
/// controller's memory of 128 x 64. Nothing is sent then.
Status init(const Ssd1306& display) noexcept;

/// Sends a strip to its place on the screen, in one window.
///
/// bad_argument: as init(); or the strip is not on the screen, its top or
/// height is not a multiple of 8, or its stride is shorter than a page.
/// buffer_small: it has fewer pixels than its pages need. Nothing is sent then.
Status write(const Ssd1306& display, const Strip& strip) noexcept;

}  // namespace inkcell::port
