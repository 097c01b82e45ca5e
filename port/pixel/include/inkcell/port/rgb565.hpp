// A canvas of RGB565, in the byte order of its strip, at any address.
#pragma once

#include <stdint.h>

#include "inkcell/canvas_colour.hpp"
#include "inkcell/port/canvas.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {
/// The pixel of an 8-bit colour: the high bits of each channel.
constexpr uint16_t rgb565(uint8_t red, uint8_t green, uint8_t blue) noexcept {
  return static_cast<uint16_t>((red >> 3) << 11 | (green >> 2) << 5 |
                               blue >> 3);
}

namespace detail {
struct Rgb565Pixels {
  Strip strip;
  uint16_t colour;

  static const SinkKind kKind;
};

// CanvasColour::put of these pixels.
void put_picture(void* pixels,
                 const ColourPicture& picture,
                 const Rect& window) noexcept;
}  // namespace detail

/// Blends in 32, 64 and 32 levels, with coverage in 32 steps: at most one level
/// off from blend(). Coverage of 255 gives the colour itself. Any address
/// works; low_first at even addresses is fastest.
class Rgb565Canvas : public Canvas<detail::Rgb565Pixels> {
 public:
  explicit Rgb565Canvas(const Strip& strip = {},
                        uint16_t colour = 0xffff) noexcept
      : Canvas(strip, colour) {}
  Rgb565Canvas(const Strip& strip,
               uint16_t colour,
               uint16_t background) noexcept
      : Rgb565Canvas(strip, background) {
    fill();
    set_colour(colour);
  }

  /// The colour of the foreground: rgb565().
  void set_colour(uint16_t colour) noexcept { pixels_.colour = colour; }
};

}  // namespace inkcell::port
