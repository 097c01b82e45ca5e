// Solomon SSD1680 and SSD1681: e-paper displays with 1-bit pixels.
//
// The controller compares two planes of memory: the new picture and the one
// that the panel shows. A full refresh needs the first alone and takes seconds;
// a partial one drives the pixels that differ, and leaves a faint trace of old
// ones, so that a full one is due from time to time.
//
//   init                                      once, and after deep sleep
//   write new strips; refresh full; write shown strips
//   write new strips of a part; refresh partial; write shown strips of it
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

enum class EpaperController : uint8_t {
  ssd1680,  // memory of 176 x 296 px
  ssd1681,  // 200 x 200
};

/// Which of the two planes a strip is written to.
enum class EpaperPlane : uint8_t {
  next,   // what the next refresh shows
  shown,  // what the panel shows
};

enum class EpaperRefresh : uint8_t { full, partial };

/// Its pixels are those of PixelFormat::mono_rows with BitOrder::high_left: 1
/// is white. So clear a strip to 0xff, and draw with MonoRowsTarget::level 0.
/// The bus sends a command's byte by `command` and its parameters by `data`,
/// and needs `wait_idle`.
struct Ssd1680 {
  DisplayBus bus;
  EpaperController controller = EpaperController::ssd1680;
  uint16_t width = 128;   // [px], a multiple of 8: the panel's or above
  uint16_t height = 296;  // [px]
  /// Only SSD1680: the panel's first column is at output S8, not S0.
  bool from_output_8 = false;
};

/// Resets the controller and sets what write() and refresh() rely on, with the
/// waveforms of the controller's own memory. Neither planes nor panel change.
///
/// bad_argument: a size is outside its range, the display is larger than the
/// controller's memory, or the bus has no `wait_idle`. Nothing is sent then.
Status init(const Ssd1680& display) noexcept;

/// Sends a strip to its place in a plane. The panel does not change.
///
/// bad_argument: what init() says; or the strip does not lie on the screen, its
/// left edge or width is not a multiple of 8, or its stride is shorter than a
/// row. buffer_small: its pixels are fewer than its rows need. Nothing is sent
/// then.
Status write(const Ssd1680& display,
             const Strip& strip,
             EpaperPlane plane) noexcept;

/// Shows the plane `next`, and returns when the panel is still. The `shown`
/// plane is the caller's to bring up to date.
///
/// bad_argument: what init() says. Nothing is sent then.
Status refresh(const Ssd1680& display, EpaperRefresh kind) noexcept;

/// Puts the controller to sleep; only a pulse of the reset line wakes it, which
/// init() sends. The memory is kept.
///
/// bad_argument: what init() says, or the bus has no `reset`. Nothing is sent
/// then.
Status sleep(const Ssd1680& display) noexcept;

}  // namespace port
}  // namespace inkcell
