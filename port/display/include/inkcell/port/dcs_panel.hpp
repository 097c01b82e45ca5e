// A colour panel with a controller for MIPI DCS commands: the common part of
// ST7735, ST7789, ILI9341 and GC9A01.
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// The rotation of the picture on the panel, clockwise.
enum class Rotation : uint8_t { none, quarter, half, three_quarters };

/// Its strips are of PixelFormat::rgb565 with ByteOrder::high_first. The bus
/// sends a command byte by `command` and its parameters by `data`, and needs
/// `wait_ms`.
///
///     memory  0 ........ first_column                     columns - 1
///             .          +--- width ---+
///       first_row        | panel       | height
///             .          +-------------+
struct DcsPanel {
  static constexpr PixelFormat kFormat = PixelFormat::rgb565;

  DisplayBus bus;
  uint16_t width = 0;   // of the panel without rotation [px]
  uint16_t height = 0;  // likewise
  /// The lowest column and row of the controller's memory that the panel shows,
  /// without mirroring.
  uint16_t first_column = 0;
  uint16_t first_row = 0;
  Rotation rotation = Rotation::none;
  /// The panel is wired from right to left, or from bottom to top.
  bool mirror_columns = false;
  bool mirror_rows = false;
  /// The panel's sub-pixel order is blue, green, red.
  bool blue_first = false;
  /// The panel shows the inverse of its memory, as most IPS panels with ST7789
  /// and GC9A01.
  bool inverted = false;
  /// Settings from the panel's maker: voltages, gamma, frame rate. For each
  /// command: its byte, the number of parameters, the parameters. init() sends
  /// them before the controller leaves sleep. Must outlive the panel.
  Span<const uint8_t> setup = {};
};

/// The differences between controllers.
struct DcsController {
  int32_t columns;       // of its memory [px]
  int32_t rows;          // likewise
  uint8_t pixel_format;  // parameter of COLMOD for 16 bits a pixel
};

namespace detail {
Status init(const DcsPanel& panel, const DcsController& controller) noexcept;
Status write(const DcsPanel& panel,
             const DcsController& controller,
             const Strip& strip) noexcept;

// `Type` where Panel is a driver of this kind.
template <typename Panel, typename Type>
using OfDcs = decltype(Panel::controller_of(Panel()), Type());
}  // namespace detail

/// Resets the controller, sends `setup`, sets what write() relies on,
/// and switches the panel on. Takes a quarter of a second.
///
/// bad_argument: the panel is empty or exceeds the controller's memory, `setup`
/// is incomplete, or the bus has no `wait_ms`. Nothing is sent then.
template <typename Panel>
detail::OfDcs<Panel, Status> init(const Panel& display) noexcept {
  return detail::init(display, Panel::controller_of(display));
}

/// Sends a strip to its place on the screen, in one window.
///
/// bad_argument: the panel is empty or exceeds the controller's memory, the
/// strip is not on the screen or has the low byte first, or its stride is
/// shorter than a row. buffer_small: it has fewer pixels than its rows need.
/// Nothing is sent then.
template <typename Panel>
detail::OfDcs<Panel, Status> write(const Panel& display,
                                   const Strip& strip) noexcept {
  return detail::write(display, Panel::controller_of(display), strip);
}

/// Width of the screen that the user sees: the panel's sides are swapped by a
/// quarter turn. [px]
constexpr int32_t screen_width(const DcsPanel& panel) noexcept {
  return (static_cast<uint8_t>(panel.rotation) & 1) != 0 ? panel.height
                                                         : panel.width;
}
/// Height of that screen. [px]
constexpr int32_t screen_height(const DcsPanel& panel) noexcept {
  return (static_cast<uint8_t>(panel.rotation) & 1) != 0 ? panel.width
                                                         : panel.height;
}

/// Switches the panel off and puts the controller to sleep; its memory and
/// settings are kept. The backlight is the board's unless the controller drives
/// it. wake() switches both on again. Each takes an eighth of a second.
///
/// bad_argument: the bus has no `wait_ms`. Nothing is sent then.
Status sleep(const DcsPanel& panel) noexcept;
/// Switches both on again.
Status wake(const DcsPanel& panel) noexcept;

/// The backlight, 0 to 255; 0 after init(). Only of panels whose backlight
/// hangs on the controller; on most modules it is a pin of the board.
void set_brightness(const DcsPanel& panel, uint8_t brightness) noexcept;

}  // namespace inkcell::port
