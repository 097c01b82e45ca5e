// A canvas of 4-bit grey, two pixels a byte.
#pragma once

#include <stdint.h>

#include "inkcell/port/canvas.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {
namespace detail {
struct Grey4Pixels {
  Strip strip;
  uint8_t level;
  BitOrder order;

  static const SinkKind kKind;
};
}  // namespace detail

/// Blends in 16 levels. Levels over 15 are clamped.
class Grey4Canvas : public Canvas<detail::Grey4Pixels> {
 public:
  static constexpr uint8_t kMaxLevel = 15;

  explicit Grey4Canvas(const Strip& strip = {},
                       uint8_t level = kMaxLevel,
                       BitOrder order = BitOrder::high_left) noexcept
      : Canvas(strip, clamped(level), order) {}
  Grey4Canvas(const Strip& strip,
              uint8_t level,
              uint8_t background,
              BitOrder order = BitOrder::high_left) noexcept
      : Grey4Canvas(strip, background, order) {
    fill();
    set_level(level);
  }

  /// The level of the foreground.
  void set_level(uint8_t level) noexcept { pixels_.level = clamped(level); }

 private:
  static constexpr uint8_t clamped(uint8_t level) noexcept {
    return level < kMaxLevel ? level : kMaxLevel;
  }
};

}  // namespace port
}  // namespace inkcell
