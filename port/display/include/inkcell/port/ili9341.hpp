// Ilitek ILI9341: colour displays of 240 x 320 pixels.
#pragma once

#include "inkcell/port/dcs_panel.hpp"

namespace inkcell::port {

/// See dcs_panel.hpp. Most modules need mirror_columns and blue_first.
struct Ili9341 : DcsPanel {
  static constexpr DcsController kController = {240, 320, 0x55};

  static constexpr const DcsController& controller_of(const Ili9341&) noexcept {
    return kController;
  }
};

}  // namespace inkcell::port
