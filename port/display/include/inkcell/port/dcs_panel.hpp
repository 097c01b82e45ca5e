// A colour panel behind a controller with MIPI DCS commands: what the drivers
// of ST7735, ST7789, ILI9341 and GC9A01 have in common.
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"
#include "inkcell/span.hpp"

namespace inkcell {
namespace port {

/// How the picture is turned on the panel, clockwise.
enum class Rotation : uint8_t { none, quarter, half, three_quarters };

/// Pixels are those of PixelFormat::rgb565 with ByteOrder::high_first. The
/// bus sends a command's byte by `command` and its parameters by `data`, and
/// needs `wait_ms`.
///
///     memory  0 ........ first_column                     columns - 1
///             .          +--- width ---+
///       first_row        | panel       | height
///             .          +-------------+
struct DcsPanel {
  DisplayBus bus;
  uint16_t width = 0;   // of the panel when it is not turned [px]
  uint16_t height = 0;  // likewise
  /// The lowest column and row of the controller's memory that the panel shows,
  /// for the orientation in which no address is mirrored.
  uint16_t first_column = 0;
  uint16_t first_row = 0;
  Rotation rotation = Rotation::none;
  /// The panel is wired from right to left, or from bottom to top.
  bool mirror_columns = false;
  bool mirror_rows = false;
  /// The panel's sub-pixels are blue, green, red.
  bool blue_first = false;
  /// The panel shows the inverse of its memory: most IPS panels of ST7789 and
  /// GC9A01.
  bool inverted = false;
  /// The panel maker's settings: voltages, gamma, frame rate. For each command
  /// its byte, the number of its parameters, and these. init() sends them
  /// before the controller leaves sleep. Must outlive the panel.
  Span<const uint8_t> setup = {};
};

/// The screen that the user sees: the panel's sides, exchanged where it is
/// turned by a quarter. [px]
constexpr int32_t screen_width(const DcsPanel& panel) noexcept {
  return (static_cast<uint8_t>(panel.rotation) & 1) != 0 ? panel.height
                                                         : panel.width;
}
constexpr int32_t screen_height(const DcsPanel& panel) noexcept {
  return (static_cast<uint8_t>(panel.rotation) & 1) != 0 ? panel.width
                                                         : panel.height;
}

}  // namespace port
}  // namespace inkcell
