// Sprites of TFT_eSPI: canvases over the memory that getPointer() returns.
//
// setRotation() and setViewport() do not affect the memory. Sprites of 8 bits
// hold 3-3-2 colours: docs/DISPLAY.md shows a sink for those.
#pragma once

#include <stdint.h>

#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/picture.hpp"
#include "inkcell/port/rgb565.hpp"

namespace inkcell::port {

/// A sprite of setColorDepth(16), high byte first. `buffer` must outlive the
/// canvas.
inline Rgb565Canvas tft_sprite16(void* buffer,
                                 int32_t width,
                                 int32_t height,
                                 uint16_t colour = 0xffff) noexcept {
  return Rgb565Canvas(
      whole_picture(static_cast<uint8_t*>(buffer), PixelFormat::rgb565, width,
                    height, ByteOrder::high_first),
      colour);
}

/// A sprite of setColorDepth(1): draws 1, or 0 with a level of 0. `buffer` must
/// outlive the canvas.
inline MonoRowsCanvas tft_sprite1(void* buffer,
                                  int32_t width,
                                  int32_t height,
                                  uint8_t level = 1) noexcept {
  return MonoRowsCanvas(whole_picture(static_cast<uint8_t*>(buffer),
                                      PixelFormat::mono_rows, width, height),
                        level);
}

}  // namespace inkcell::port
