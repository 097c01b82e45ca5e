// A canvas of four bytes a pixel: blue, green, red, x.
#pragma once

#include <stdint.h>

#include "inkcell/port/canvas.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {
namespace detail {
struct Xrgb8888Pixels {
  Strip strip;
  uint32_t colour;

  static const SinkKind kKind;
};
}  // namespace detail

/// Byte x is blended as a fourth channel: if it is 255 in the colour and the
/// strip, it stays 255, and the strip is also opaque ARGB8888.
///
/// Strip::pixels.data and Strip::stride must be multiples of 4 bytes: a pixel
/// is read and written as a word.
class Xrgb8888Canvas : public Canvas<detail::Xrgb8888Pixels> {
 public:
  explicit Xrgb8888Canvas(const Strip& strip = {},
                          uint32_t colour = 0xffffffff) noexcept
      : Canvas(strip, colour) {}
  Xrgb8888Canvas(const Strip& strip,
                 uint32_t colour,
                 uint32_t background) noexcept
      : Xrgb8888Canvas(strip, background) {
    fill();
    set_colour(colour);
  }

  /// The colour of the foreground: 0xXXRRGGBB.
  void set_colour(uint32_t colour) noexcept { pixels_.colour = colour; }
};

}  // namespace inkcell::port
