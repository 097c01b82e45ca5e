// Sitronix ST7789: colour displays of up to 240 x 320 pixels.
#pragma once

#include "inkcell/port/dcs_panel.hpp"

namespace inkcell::port {

/// See dcs_panel.hpp. Panels of 240 x 240 begin at (0, 0), those of 135 x 240
/// at (52, 40) or (53, 40).
struct St7789 : DcsPanel {
  static constexpr DcsController kController = {240, 320, 0x55};

  static constexpr const DcsController& controller_of(const St7789&) noexcept {
    return kController;
  }
};

}  // namespace inkcell::port
