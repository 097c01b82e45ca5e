// Draws and sends the screen, or a part of it, strip by strip with a small
// buffer.
//
//   static uint8_t rows[strip_bytes(PixelFormat::rgb565, 240, 16)];
//   StripLoop loop = loop_over(display, rows);  // of display_loop.hpp
//   loop.context = &scene;
//   loop.draw = draw;
//   INKCELL_TRY(run_strips(loop));              // the screen
//   INKCELL_TRY(run_strips(loop, label.box())); // a part
#pragma once

#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// A screen, the memory for its strips, and the functions that draw and send
/// them. The caller owns the memory. Strips are as high as the buffer allows:
/// those of a narrow part have more rows.
struct StripLoop {
  /// For a strip. strip_bytes() says how large, for a row at least.
  Span<uint8_t> buffer;
  /// Optional: a second one, of the same size, without overlap. Then a strip is
  /// drawn while the one before it is sent by DMA: flush() starts a transfer
  /// and returns, wait() returns at its end.
  ///
  ///     draw 0 | draw 1 | wait | draw 2 | wait | ... | wait
  ///            flush 0         flush 1         flush 2
  ///            |-- sent -->    |-- sent -->
  Span<uint8_t> second;
  PixelFormat format = PixelFormat::rgb565;
  ByteOrder order = ByteOrder::low_first;  // of all strips
  int32_t width = 0;                       // of the screen [px], 1..32767
  int32_t height = 0;                      // likewise

  /// The first argument of `draw`.
  void* context = nullptr;
  /// Draws everything that meets the strip: background first, then text.
  Status (*draw)(void* context, const Strip& strip) = nullptr;

  /// The first argument of `flush` and `wait`.
  void* display = nullptr;
  /// Sends the strip to its place on the screen.
  Status (*flush)(void* display, const Strip& strip) = nullptr;
  /// Returns when no transfer is under way. Needed with a second buffer, and if
  /// flush() returns before the strip is sent.
  Status (*wait)(void* display) = nullptr;
};

/// Calls draw and flush for the strips of `part`, from top to bottom, and waits
/// for the last transfer. The part is cut to the screen, and widened to whole
/// bytes and pages. Nothing is called if it is empty. The picture is the same
/// for every size of the buffer.
///
/// bad_argument: a side of the screen is out of range, a function is missing,
/// or the buffers overlap. buffer_small: a buffer does not hold a row, or page,
/// of the part. Nothing is called then. Any other result is the first of draw,
/// flush or wait that is not `ok`; nothing is sent after it.
Status run_strips(const StripLoop& loop, const Rect& part) noexcept;

/// The whole screen.
inline Status run_strips(const StripLoop& loop) noexcept {
  return run_strips(loop, {0, 0, loop.width, loop.height});
}

}  // namespace inkcell::port
