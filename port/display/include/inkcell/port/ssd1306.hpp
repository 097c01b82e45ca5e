// Solomon SSD1306: OLED displays with 1-bit pixels, I2C or SPI.
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// A display of up to 128 x 64 pixels. Its pixels are those of
/// PixelFormat::mono_pages.
struct Ssd1306 {
  DisplayBus bus;
  uint8_t width = 128;       // [px]
  uint8_t height = 64;       // [px], a multiple of 8, 16 to 64
  uint8_t first_column = 0;  // the lowest segment output that the panel uses
  /// Turns the picture by 180 degrees: with most modules the connector is then
  /// above it.
  bool turned = false;
  /// Rows are wired to outputs in their order, as on panels of 128 x 32; on
  /// those of 128 x 64 they alternate between both halves.
  bool sequential_rows = false;
  /// The panel is supplied by the controller's charge pump.
  bool charge_pump = true;
};

/// Pulses the reset line if there is one, sets what write() relies on, and
/// switches the panel on. The contents of the display's memory are not changed.
/// Contrast, clock and pre-charge are the board's to send, through the same
/// bus.
///
/// bad_argument: a size is outside its range, or the display is larger than the
/// controller's memory of 128 x 64. Nothing is sent then.
Status init(const Ssd1306& display) noexcept;

/// Sends a strip to its place on the screen, in one window.
///
/// bad_argument: what init() says; or the strip does not lie on the screen, its
/// top or height is not a multiple of 8, or its stride is shorter than a page.
/// buffer_small: its pixels are fewer than its pages need. Nothing is sent
/// then.
Status write(const Ssd1306& display, const Strip& strip) noexcept;

}  // namespace port
}  // namespace inkcell
