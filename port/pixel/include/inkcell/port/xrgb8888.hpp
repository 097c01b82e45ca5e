// A sink for four bytes a pixel: blue, green, red, x.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// Byte x is blended as a fourth channel: if it is 255 in the colour and the
/// strip, it stays 255, and the strip is also opaque ARGB8888.
///
/// Strip::pixels.data and Strip::stride must be multiples of 4 bytes: a pixel
/// is read and written as a word.
struct Xrgb8888Target {
  Strip strip;
  uint32_t colour = 0xffffffff;  // of the foreground: 0xXXRRGGBB
};

/// `target` must outlive `out`. Errors: see pixel.hpp.
Status make_sink(Xrgb8888Target& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
