// Sitronix ST7789: colour displays of up to 240 x 320 pixels.
#pragma once

#include "inkcell/port/dcs_panel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// See dcs_panel.hpp. Panels of 240 x 240 begin at (0, 0), those of 135 x 240
/// at (52, 40) or (53, 40).
struct St7789 : DcsPanel {};

/// Resets the controller, sends `setup`, sets what write() relies on,
/// and switches the panel on. Takes a quarter of a second.
///
/// bad_argument: the panel is empty or exceeds the controller's memory, `setup`
/// is incomplete, or the bus has no `wait_ms`. Nothing is sent then.
Status init(const St7789& display) noexcept;

/// Sends a strip to its place on the screen, in one window.
///
/// bad_argument: the panel is empty or exceeds the controller's memory, the
/// strip is not on the screen or has the low byte first, or its stride is
/// shorter than a row. buffer_small: it has fewer pixels than its rows need.
/// Nothing is sent then.
Status write(const St7789& display, const Strip& strip) noexcept;

}  // namespace inkcell::port
