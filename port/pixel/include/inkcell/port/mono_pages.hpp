// A canvas of 1-bit pixels in pages, the format of SSD1306 and SSD0303.
#pragma once

#include <stdint.h>

#include "inkcell/few_levels.hpp"
#include "inkcell/port/canvas.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {
namespace detail {
struct MonoPagesPixels {
  Strip strip;
  uint8_t threshold;
  uint8_t level;

  static const SinkKind kKind;
};
}  // namespace detail

/// A byte is a column of 8 pixels, bit 0 on top; a page is a row of such bytes.
///
///                 x = 0   1   2
///     y = 0..7   byte 0   1   2 ...      Strip::stride is from one page
///     y = 8..15  stride + 0   1 ...      to the next
///
/// Strip::y0 is the top of the first page. If the height is not a multiple of
/// 8, the lowest pixels of the last page are unchanged. A pixel is drawn if its
/// coverage is at least the threshold.
class MonoPagesCanvas : public Canvas<detail::MonoPagesPixels> {
 public:
  static constexpr uint8_t kThreshold = 128;

  /// A level of 1 sets the bits of drawn pixels, 0 clears them.
  explicit MonoPagesCanvas(const Strip& strip = {}, uint8_t level = 1) noexcept
      : Canvas(strip, kThreshold, level) {}
  MonoPagesCanvas(const Strip& strip,
                  uint8_t level,
                  uint8_t background) noexcept
      : MonoPagesCanvas(strip, background) {
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
