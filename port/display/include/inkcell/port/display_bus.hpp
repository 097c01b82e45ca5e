// The connection of a display driver to its controller: functions of the board.
//
// The driver knows the controller's commands, the board the wiring. `command`
// and `data` block until the bytes are sent, or copy them: the driver's buffer
// is temporary.
//
//   SPI  command: D/C low, then the bytes.   data: D/C high, then the bytes.
//   I2C  command: one transfer a byte, 0x80 before it.
//        data: one transfer, 0x40 before the first byte.
//
// i2c_display.hpp makes both from a function that writes to an I2C bus.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/cpp17.hpp"

namespace inkcell::port {

/// The functions by which a driver reaches a display.
struct DisplayBus {
  /// The first argument of each function.
  void* context = nullptr;
  /// Sends commands: a command and its parameters, or the command alone if the
  /// controller takes parameters as data. Must not throw, like all functions
  /// here; plain C functions fit.
  void (*command)(void* context, const uint8_t* bytes, size_t count) = nullptr;
  /// Sends pixels, or parameters.
  void (*data)(void* context, const uint8_t* bytes, size_t count) = nullptr;
  /// Optional: starts to send the pixels of a strip, by DMA, and may return
  /// before they are sent; `bytes` do not change until then. The next call of
  /// any function here waits for the end. If null, data() sends them.
  void (*start)(void* context, const uint8_t* bytes, size_t count) = nullptr;
  /// Returns when the transfer that start() began has ended, at once if there
  /// is none. Needed with start() and with a second buffer (strip_loop.hpp).
  void (*wait_sent)(void* context) = nullptr;
  /// Optional: pulses the reset line, and returns when the controller accepts
  /// commands. Null if there is no line, or the board resets it.
  void (*reset)(void* context) = nullptr;
  /// Returns after at least `ms` milliseconds. Drivers that need it say so.
  void (*wait_ms)(void* context, uint32_t ms) = nullptr;
  /// Returns when the controller's BUSY line is idle; the timeout is the
  /// board's decision. Drivers that need it say so.
  void (*wait_idle)(void* context) = nullptr;
};

}  // namespace inkcell::port
