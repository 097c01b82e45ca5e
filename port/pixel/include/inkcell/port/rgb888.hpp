// A canvas of three bytes a pixel.
#pragma once

#include <stdint.h>

#include "inkcell/port/canvas.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {
/// The channel at the lowest address.
enum class ChannelOrder : uint8_t { red_first, blue_first };

namespace detail {
struct Rgb888Pixels {
  Strip strip;
  uint32_t colour;
  ChannelOrder order;

  static const SinkKind kKind;
};
}  // namespace detail

/// Pixels of three bytes.
class Rgb888Canvas : public Canvas<detail::Rgb888Pixels> {
 public:
  explicit Rgb888Canvas(const Strip& strip = {},
                        uint32_t colour = 0xffffff,
                        ChannelOrder order = ChannelOrder::red_first) noexcept
      : Canvas(strip, colour, order) {}
  Rgb888Canvas(const Strip& strip,
               uint32_t colour,
               uint32_t background,
               ChannelOrder order = ChannelOrder::red_first) noexcept
      : Rgb888Canvas(strip, background, order) {
    fill();
    set_colour(colour);
  }

  /// The colour of the foreground: 0xRRGGBB.
  void set_colour(uint32_t colour) noexcept { pixels_.colour = colour; }
};

}  // namespace inkcell::port
