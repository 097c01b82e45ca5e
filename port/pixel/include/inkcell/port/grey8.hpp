// A canvas of 8-bit grey.
#pragma once

#include <stdint.h>

#include "inkcell/port/canvas.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {
namespace detail {
struct Grey8Pixels {
  Strip strip;
  uint8_t level;

  static const SinkKind kKind;
};
}  // namespace detail

/// Pixels of one byte: 0 is black, 255 white.
class Grey8Canvas : public Canvas<detail::Grey8Pixels> {
 public:
  explicit Grey8Canvas(const Strip& strip = {}, uint8_t level = 255) noexcept
      : Canvas(strip, level) {}
  Grey8Canvas(const Strip& strip, uint8_t level, uint8_t background) noexcept
      : Grey8Canvas(strip, background) {
    fill();
    set_level(level);
  }

  /// The level of the foreground.
  void set_level(uint8_t level) noexcept { pixels_.level = level; }
};

}  // namespace inkcell::port
