// Commands that all controllers of OLED panels have.
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"

namespace inkcell::port {

enum OledCommand : uint8_t {
  kSetContrast = 0x81,
  kDisplayOff = 0xae,
  kDisplayOn = 0xaf,
};

inline void send_power(const DisplayBus& bus, OledCommand on_or_off) noexcept {
  const uint8_t command[] = {on_or_off};
  bus.command(bus.context, command, sizeof command);
}

inline void send_contrast(const DisplayBus& bus, uint8_t contrast) noexcept {
  const uint8_t command[] = {kSetContrast, contrast};
  bus.command(bus.context, command, sizeof command);
}

}  // namespace inkcell::port
