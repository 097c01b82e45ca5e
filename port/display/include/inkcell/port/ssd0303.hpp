// Solomon SSD0303: OLED displays with 1-bit pixels in pages of 8 rows.
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
struct Ssd0303 {
  static constexpr PixelFormat kFormat = PixelFormat::mono_pages;
  static constexpr uint8_t kContrastShift = 0;

  DisplayBus bus;
  uint8_t width = 132;       // [px]
  uint8_t height = 64;       // [px], a multiple of 8
  uint8_t first_column = 0;  // of the memory's 132, the leftmost on the panel;
                             // first_column + width are at most 132
};

/// Sets the addressing that write() relies on, and switches the panel on. The
/// display's memory is unchanged.
///
/// The board sends what depends on panel and wiring through the same bus: DC-DC
/// converter or charge pump, clock, multiplex ratio, and after init() the remap
/// for a panel mounted upside down.
void init(const Ssd0303& display) noexcept;

/// Sends a strip to its place on the screen, page by page.
///
/// bad_argument: the display is larger than the controller's memory, the strip
/// is not on the screen, its top or height is not a multiple of 8, or its
/// stride is shorter than a page. buffer_small: it has fewer pixels than its
/// pages need. Nothing is sent then.
Status write(const Ssd0303& display, const Strip& strip) noexcept;

}  // namespace inkcell::port
