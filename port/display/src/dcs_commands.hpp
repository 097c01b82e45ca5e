// MIPI DCS commands that the drivers of colour panels share.
#pragma once

#include <stdint.h>

#include "inkcell/port/dcs_panel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port::detail {

/// The differences between controllers.
struct DcsController {
  int32_t columns;       // of its memory [px]
  int32_t rows;          // likewise
  uint8_t pixel_format;  // parameter of COLMOD for 16 bits a pixel
};

/// init() and write() of the drivers' headers.
Status init(const DcsPanel& panel, const DcsController& controller) noexcept;
Status write(const DcsPanel& panel,
             const DcsController& controller,
             const Strip& strip) noexcept;

}  // namespace inkcell::port::detail
