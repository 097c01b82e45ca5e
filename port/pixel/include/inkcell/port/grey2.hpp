// A canvas of 2-bit grey, four pixels a byte.
#pragma once

#include <stdint.h>

#include "inkcell/port/canvas.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {
namespace detail {
struct Grey2Pixels {
  Strip strip;
  uint8_t level;
  BitOrder order;

  static const SinkKind kKind;
};
}  // namespace detail

/// Blends in 4 levels. Levels over 3 are clamped.
class Grey2Canvas : public Canvas<detail::Grey2Pixels> {
 public:
  static constexpr uint8_t kMaxLevel = 3;

  explicit Grey2Canvas(const Strip& strip = {},
                       uint8_t level = kMaxLevel,
                       BitOrder order = BitOrder::high_left) noexcept
      : Canvas(strip, clamped(level), order) {}
  Grey2Canvas(const Strip& strip,
              uint8_t level,
              uint8_t background,
              BitOrder order = BitOrder::high_left) noexcept
      : Grey2Canvas(strip, background, order) {
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
