// Commands of controllers that take parameters as data.
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"
#include "inkcell/span.hpp"

namespace inkcell::port {

/// Sends a command byte, then its parameters, if any, as data.
inline void send_command(const DisplayBus& bus,
                         uint8_t command,
                         Span<const uint8_t> parameters = {}) noexcept {
  bus.command(bus.context, &command, 1);
  if (parameters.size != 0) {
    bus.data(bus.context, parameters.data, parameters.size);
  }
}

}  // namespace inkcell::port
