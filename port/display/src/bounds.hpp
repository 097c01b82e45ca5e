// Whether a strip can be sent to a display: the checks of all drivers.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// check_strip(); and bad_argument if `strip` is empty, not within a screen of
/// `width` x `height` px, or has edges inside a byte of `format`.
inline Status check_on_screen(const Strip& strip,
                              PixelFormat format,
                              int32_t width,
                              int32_t height) noexcept {
  INKCELL_TRY(check_strip(strip, format));
  // Differences, because sums with an untrusted size could overflow.
  if (strip.width <= 0 || strip.width > width || strip.height <= 0 ||
      strip.height > height || strip.x0 < 0 || strip.x0 > width - strip.width ||
      strip.y0 < 0 || strip.y0 > height - strip.height) {
    return Status::bad_argument;
  }
  const int32_t cut = format == PixelFormat::mono_pages
                          ? strip.y0 | strip.height
                          : (strip.x0 | strip.width) * bits_per_pixel(format);
  return (cut & 7) != 0 ? Status::bad_argument : Status::ok;
}

}  // namespace inkcell::port
