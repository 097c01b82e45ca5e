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

/// Blends in 32, 64 and 32 levels, with coverage in 32 steps: at most one level
/// off from blend(). Coverage of 255 gives the colour itself. Any address
/// works; low_first at even addresses is fastest.
struct Rgb565Target {
  Strip strip;
  uint16_t colour = 0xffff;  // of the foreground: rgb565()
  ByteOrder order = ByteOrder::low_first;
};

/// `target` must outlive `out`. Errors: see pixel.hpp.
Status make_sink(Rgb565Target& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
