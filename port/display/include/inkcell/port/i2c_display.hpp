// Displays on I2C: a DisplayBus from one function of the board.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/port/display_bus.hpp"

namespace inkcell::port {

/// For controllers with a control byte before commands and pixels: SSD1306,
/// SH1106 and their relatives. The board's function writes one transfer, from
/// start condition and address to stop condition.
struct I2cDisplay {
  /// The first argument of `write`.
  void* context = nullptr;
  /// Sends `count` bytes, at most kI2cTransfer, to the 7-bit `address`. Blocks
  /// until they are sent, or copies them.
  void (*write)(void* context,
                uint8_t address,
                const uint8_t* bytes,
                size_t count) = nullptr;
  uint8_t address = 0x3c;  // or 0x3d, by pin SA0
};

/// The longest transfer: a control byte and 31 others, for I2C drivers with
/// buffers of 32 bytes. [bytes]
inline constexpr size_t kI2cTransfer = 32;

/// `display` must outlive the bus.
DisplayBus make_bus(I2cDisplay& display) noexcept;

}  // namespace inkcell::port
