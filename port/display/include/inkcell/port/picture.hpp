// A whole picture in memory as a strip.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// A picture of `width` x `height` px (each 0..32767), first pixel at (0, 0),
/// without gaps between rows or pages. `pixels` has strip_bytes() bytes and
/// must outlive the strip.
constexpr Strip whole_picture(uint8_t* pixels,
                              PixelFormat format,
                              int32_t width,
                              int32_t height,
                              ByteOrder order = ByteOrder::low_first) noexcept {
  return {{pixels, strip_bytes(format, width, height)},
          0,
          0,
          width,
          height,
          stride_bytes(format, width),
          order};
}

}  // namespace inkcell::port
