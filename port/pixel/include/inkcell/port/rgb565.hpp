// A sink for RGB565, either byte first, at any address.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// The pixel of an 8-bit colour: the high bits of each channel.
constexpr uint16_t rgb565(uint8_t red, uint8_t green, uint8_t blue) noexcept {
  return static_cast<uint16_t>((red >> 3) << 11 | (green >> 2) << 5 |
                               blue >> 3);
}

/// Blends on the 32, 64 and 32 levels that are stored, with coverage in 32
/// steps: all three channels in one word, each a level from what blend() says
/// at the most. Coverage of 255 is the colour itself. Pixels may lie at any
/// address; low_first at even ones is quickest.
struct Rgb565Target {
  Strip strip;
  uint16_t colour = 0xffff;  // of the foreground: rgb565()
  ByteOrder order = ByteOrder::low_first;
};

/// `target` must outlive `out`. Errors: see pixel.hpp.
Status make_sink(Rgb565Target& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
