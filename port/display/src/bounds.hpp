// Whether a strip can be sent to a display: the checks of all drivers.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// bad_argument: `strip` has no pixels, leaves a screen of `width` x `height`
/// px, its edges lie inside a byte of `format`, or its stride is shorter than a
/// row. buffer_small: its pixels are fewer than its rows need.
inline Status check_strip(const Strip& strip,
                          PixelFormat format,
                          int32_t width,
                          int32_t height) noexcept {
  // Differences, because sums of untrusted numbers could overflow.
  if (strip.width <= 0 || strip.width > width || strip.height <= 0 ||
      strip.height > height || strip.x0 < 0 || strip.x0 > width - strip.width ||
      strip.y0 < 0 || strip.y0 > height - strip.height) {
    return Status::bad_argument;
  }
  const bool pages = format == PixelFormat::mono_pages;
  if (pages ? ((strip.y0 | strip.height) & 7) != 0
            : (((strip.x0 | strip.width) * bits_per_pixel(format)) & 7) != 0) {
    return Status::bad_argument;
  }
  const int32_t row = stride_bytes(format, strip.width);
  if (strip.stride < row || strip.stride > 0xffff) {
    return Status::bad_argument;
  }
  const int32_t rows = pages ? strip.height / 8 : strip.height;
  const size_t needed =
      static_cast<size_t>(strip.stride) * static_cast<size_t>(rows - 1) +
      static_cast<size_t>(row);
  return strip.pixels.size < needed ? Status::buffer_small : Status::ok;
}

}  // namespace port
}  // namespace inkcell
