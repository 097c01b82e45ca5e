// What the drivers of OLED panels share: SSD1306, SH1106, SSD0303, SSD0323.
#pragma once

#include <stdint.h>

#include "inkcell/port/display_bus.hpp"

namespace inkcell::port {
namespace detail {
inline constexpr uint8_t kOledContrast = 0x81;
inline constexpr uint8_t kOledOff = 0xae;
inline constexpr uint8_t kOledOn = 0xaf;

// void where Panel is a driver of this kind.
template <typename Panel>
using OfOled = decltype(static_cast<void>(Panel::kContrastShift));
}  // namespace detail

/// Switches the panel off, and on again. The memory is kept, and write() works
/// meanwhile.
template <typename Panel>
detail::OfOled<Panel> sleep(const Panel& display) noexcept {
  display.bus.command(display.bus.context, &detail::kOledOff, 1);
}
/// Switches it on again.
template <typename Panel>
detail::OfOled<Panel> wake(const Panel& display) noexcept {
  display.bus.command(display.bus.context, &detail::kOledOn, 1);
}

/// How bright pixels are, 0 to 255; 128 after a reset, 127 of an SSD1306. An
/// SSD0323 has 128 steps.
template <typename Panel>
detail::OfOled<Panel> set_contrast(const Panel& display,
                                   uint8_t contrast) noexcept {
  const uint8_t command[] = {
      detail::kOledContrast,
      static_cast<uint8_t>(contrast >> Panel::kContrastShift)};
  display.bus.command(display.bus.context, command, sizeof command);
}

}  // namespace inkcell::port
