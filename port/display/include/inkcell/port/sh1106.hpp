// Sino Wealth SH1106: OLED displays with 1-bit pixels, I2C or SPI.
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// A display of up to 132 x 64 pixels. Its pixels are those of
/// PixelFormat::mono_pages.
struct Sh1106 {
  DisplayBus bus;
  uint8_t width = 128;       // [px]
  uint8_t height = 64;       // [px], a multiple of 8
  uint8_t first_column = 2;  // the lowest segment output that the panel uses
  /// Turns the picture by 180 degrees: with most modules the connector is then
  /// above it.
  bool turned = false;
  /// The panel is supplied by the controller's DC-DC converter.
  bool converter = true;
};

/// Pulses the reset line if there is one, sets what write() relies on, and
/// switches the panel on. The contents of the display's memory are not changed.
/// Contrast, clock and pump voltage are the board's to send, through the same
/// bus.
///
/// bad_argument: a size is outside its range, or the display is larger than the
/// controller's memory of 132 x 64. Nothing is sent then.
Status init(const Sh1106& display) noexcept;

/// Sends a strip to its place on the screen, page by page.
///
/// bad_argument: what init() says; or the strip does not lie on the screen, its
/// top or height is not a multiple of 8, or its stride is shorter than a page.
/// buffer_small: its pixels are fewer than its pages need. Nothing is sent
/// then.
Status write(const Sh1106& display, const Strip& strip) noexcept;

}  // namespace port
}  // namespace inkcell
