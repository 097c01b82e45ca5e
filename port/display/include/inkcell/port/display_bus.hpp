// How a display driver talks to its controller: two functions of the board.
//
// A driver knows the controller's commands, the board knows the wires. Both
// functions block until the bytes are sent, or copy them: the driver's buffer
// is gone afterwards.
//
//   SPI  command: D/C low, then the bytes.   data: D/C high, then the bytes.
//   I2C  command: one transfer a byte, 0x80 before it.
//        data: one transfer, 0x40 before the first byte.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace inkcell {
namespace port {

struct DisplayBus {
  /// Passed back as the first argument of both functions.
  void* context = nullptr;
  /// Sends a command and its parameters. Throws nothing: plain C functions fit.
  void (*command)(void* context, const uint8_t* bytes, size_t count) = nullptr;
  /// Sends pixels. Throws nothing.
  void (*data)(void* context, const uint8_t* bytes, size_t count) = nullptr;
};

}  // namespace port
}  // namespace inkcell
