// Sprites of TFT_eSPI: targets in the memory that getPointer() returns.
//
// setRotation() and setViewport() do not affect the memory. Sprites of 8 bits
// hold 3-3-2 colours: docs/PORTING.md shows a sink for those.
#pragma once

#include <stdint.h>

#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/picture.hpp"
#include "inkcell/port/rgb565.hpp"

namespace inkcell {
namespace port {

/// A sprite of setColorDepth(16), high byte first: draws white, or
/// Rgb565Target::colour. `buffer` must outlive the target.
inline Rgb565Target tft_sprite16(void* buffer,
                                 int32_t width,
                                 int32_t height) noexcept {
  Rgb565Target target;
  target.strip = whole_picture(static_cast<uint8_t*>(buffer),
                               PixelFormat::rgb565, width, height);
  target.order = ByteOrder::high_first;
  return target;
}

/// A sprite of setColorDepth(1): draws 1, or 0 with MonoRowsTarget::level 0.
/// `buffer` must outlive the target.
inline MonoRowsTarget tft_sprite1(void* buffer,
                                  int32_t width,
                                  int32_t height) noexcept {
  MonoRowsTarget target;
  target.strip = whole_picture(static_cast<uint8_t*>(buffer),
                               PixelFormat::mono_rows, width, height);
  target.order = BitOrder::high_left;
  return target;
}

}  // namespace port
}  // namespace inkcell
