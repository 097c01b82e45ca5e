// Sitronix ST7735: colour displays of up to 132 x 162 pixels.
#pragma once

#include "inkcell/port/dcs_panel.hpp"

namespace inkcell::port {

/// See dcs_panel.hpp. On modules of 128 x 160 the panel begins at (0, 0) of a
/// memory of 128 x 160, or at (2, 1) of 132 x 162.
struct St7735 : DcsPanel {
  /// Pins GM: 011 selects a memory of 128 x 160, 000 one of 132 x 162.
  bool gm_011 = false;

  static constexpr DcsController kSmall = {128, 160, 0x05};
  static constexpr DcsController kLarge = {132, 162, 0x05};

  static constexpr const DcsController& controller_of(
      const St7735& display) noexcept {
    return display.gm_011 ? kSmall : kLarge;
  }
};

/// The controller drives no backlight.
void set_brightness(const St7735& display, uint8_t brightness) = delete;

}  // namespace inkcell::port
