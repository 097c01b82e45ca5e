// A canvas of 1-bit pixels, eight along the row in a byte.
#pragma once

#include <stdint.h>

#include "inkcell/few_levels.hpp"
#include "inkcell/port/canvas.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {
namespace detail {
struct MonoRowsPixels {
  Strip strip;
  uint8_t threshold;
  uint8_t level;
  BitOrder order;

  static const SinkKind kKind;
};
}  // namespace detail

/// A pixel is drawn if its coverage is at least the threshold.
class MonoRowsCanvas : public Canvas<detail::MonoRowsPixels> {
 public:
  static constexpr uint8_t kThreshold = 128;

  /// A level of 1 sets the bits of drawn pixels, 0 clears them.
  explicit MonoRowsCanvas(const Strip& strip = {},
                          uint8_t level = 1,
                          BitOrder order = BitOrder::high_left) noexcept
      : Canvas(strip, kThreshold, level, order) {}
  MonoRowsCanvas(const Strip& strip,
                 uint8_t level,
                 uint8_t background,
                 BitOrder order = BitOrder::high_left) noexcept
      : MonoRowsCanvas(strip, background, order) {
    fill();
    set_level(level);
  }

  /// A style of fitted text, for what lays text out without a canvas. Painter
  /// and TextBox::draw() fit text by themselves.
  static constexpr Style style(Q26_6 size) noexcept {
    return two_level_style(size);
  }

  void set_level(uint8_t level) noexcept { pixels_.level = level; }

  /// The least coverage that is drawn, kThreshold by default; 0 counts as 1.
  void set_threshold(uint8_t threshold) noexcept {
    pixels_.threshold = threshold == 0 ? 1 : threshold;
    if (threshold != kThreshold) {
      levels = detail::shifted_two_level_rule();
    }
  }
};

}  // namespace inkcell::port
