// A canvas of 4-bit grey, two pixels a byte.
#pragma once

#include <stdint.h>

#include "inkcell/port/level_canvas.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {
namespace detail {
struct Grey4Pixels {
  Strip strip;
  uint8_t level;
  BitOrder order;

  static const SinkKind kKind;
};
}  // namespace detail

/// Blends in 16 levels, 0 to 15.
class Grey4Canvas : public detail::LevelCanvas<detail::Grey4Pixels, 15> {
 public:
  using LevelCanvas::LevelCanvas;
};

}  // namespace inkcell::port
