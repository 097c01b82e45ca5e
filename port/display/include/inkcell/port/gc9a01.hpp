// Galaxycore GC9A01: round colour displays of 240 x 240 pixels.
#pragma once

#include "inkcell/port/dcs_panel.hpp"

namespace inkcell::port {

/// See dcs_panel.hpp. Most panels need the maker's settings in DcsPanel::setup.
/// round_strip() of round_strip.hpp skips pixels outside of the circle.
struct Gc9a01 : DcsPanel {
  static constexpr DcsController kController = {240, 240, 0x55};

  static constexpr const DcsController& controller_of(const Gc9a01&) noexcept {
    return kController;
  }
};

}  // namespace inkcell::port
