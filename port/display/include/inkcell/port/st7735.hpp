// Sitronix ST7735: colour displays of up to 132 x 162 pixels.
#pragma once

#include "inkcell/port/dcs_panel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// See dcs_panel.hpp. On modules of 128 x 160 the panel begins at (0, 0) of a
/// memory of 128 x 160, or at (2, 1) of 132 x 162.
struct St7735 : DcsPanel {
  /// Pins GM: 011 selects a memory of 128 x 160, 000 one of 132 x 162.
  bool gm_011 = false;
};

/// Resets the controller, sends `setup`, sets what write() relies on,
/// and switches the panel on. Takes a quarter of a second.
///
/// bad_argument: the panel is empty or exceeds the controller's memory, `setup`
/// is incomplete, or the bus has no `wait_ms`. Nothing is sent then.
Status init(const St7735& display) noexcept;

/// Sends a strip to its place on the screen, in one window.
///
/// bad_argument: the panel is empty or exceeds the controller's memory, the
/// strip is not on the screen or has the low byte first, or its stride is
/// shorter than a row. buffer_small: it has fewer pixels than its rows need.
/// Nothing is sent then.
Status write(const St7735& display, const Strip& strip) noexcept;

/// The controller drives no backlight.
void set_brightness(const St7735& display, uint8_t brightness) = delete;

}  // namespace inkcell::port
