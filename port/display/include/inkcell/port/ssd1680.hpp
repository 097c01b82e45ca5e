// Solomon SSD1680 and SSD1681: e-paper displays with 1-bit pixels.
//
// The controller has two planes of memory: the next picture, and the one that
// the panel shows. A full refresh uses only the first and takes seconds. A
// partial refresh drives only the pixels that differ and leaves a faint trace
// of the old ones, so a full one is needed from time to time.
//
//   init                                      once, and after deep sleep
//   write new strips; refresh full; write shown strips
//   write new strips of a part; refresh partial; write shown strips of it
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// The controller of a panel.
enum class EpaperController : uint8_t {
  ssd1680,  // memory of 176 x 296 px
  ssd1681,  // 200 x 200
};

/// The plane that a strip is written to.
enum class EpaperPlane : uint8_t {
  next,   // for the next refresh
  shown,  // as on the panel
};

/// How the panel shows what is new: all of it, by flashes, or what differs.
enum class EpaperRefresh : uint8_t { full, partial };

/// Its pixels are those of PixelFormat::mono_rows with BitOrder::high_left, and
/// 1 is white: clear strips to 0xff and draw with level 0. The
/// bus sends a command byte by `command` and its parameters by `data`, and
/// needs `wait_idle`.
struct Ssd1680 {
  static constexpr PixelFormat kFormat = PixelFormat::mono_rows;

  DisplayBus bus;
  EpaperController controller = EpaperController::ssd1680;
  uint16_t width = 128;   // [px], a multiple of 8: the panel's, rounded up
  uint16_t height = 296;  // [px]
  /// Only SSD1680: the panel's first column is at output S8, not S0.
  bool from_output_8 = false;
};

/// Resets the controller and sets what write() and refresh() rely on, with the
/// waveforms in the controller's memory. Planes and panel are unchanged.
///
/// bad_argument: a size is out of range, the display is larger than the
/// controller's memory, or the bus has no `wait_idle`. Nothing is sent then.
Status init(const Ssd1680& display) noexcept;

/// Sends a strip to its place in a plane. The panel does not change.
///
/// bad_argument: as init(); or the strip is not on the screen, its left edge or
/// width is not a multiple of 8, or its stride is shorter than a row.
/// buffer_small: it has fewer pixels than its rows need. Nothing is sent then.
Status write(const Ssd1680& display,
             const Strip& strip,
             EpaperPlane plane = EpaperPlane::next) noexcept;

/// Shows the plane `next`, and returns when the panel is done. The caller then
/// updates the plane `shown`.
///
/// bad_argument: as init(). Nothing is sent then.
Status refresh(const Ssd1680& display, EpaperRefresh kind) noexcept;

/// Puts the controller to sleep. Only a reset wakes it, which init() sends. The
/// memory is kept.
///
/// bad_argument: as init(), or the bus has no `reset`. Nothing is sent then.
Status sleep(const Ssd1680& display) noexcept;

}  // namespace inkcell::port
