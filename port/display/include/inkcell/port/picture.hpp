// A strip that is a whole picture in memory.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// The memory of a picture of `width` x `height` px (each 0..32767) whose rows,
/// or pages, follow each other without gaps. Its first pixel is at (0, 0).
/// `pixels` are strip_bytes() bytes, and must outlive the strip.
constexpr Strip whole_picture(uint8_t* pixels,
                              PixelFormat format,
                              int32_t width,
                              int32_t height) noexcept {
  return {{pixels, strip_bytes(format, width, height)},
          0,
          0,
          width,
          height,
          stride_bytes(format, width)};
}

}  // namespace port
}  // namespace inkcell
