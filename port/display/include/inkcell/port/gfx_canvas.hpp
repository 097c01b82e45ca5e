// Canvases of Adafruit_GFX: targets in the memory that getBuffer() returns.
//
// A canvas has the size given to its constructor; setRotation() only affects
// drawing by Adafruit_GFX. `buffer` must outlive the target.
#pragma once

#include <stdint.h>

#include "inkcell/port/grey8.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/picture.hpp"
#include "inkcell/port/rgb565.hpp"

namespace inkcell {
namespace port {

/// GFXcanvas1: draws 1, or 0 with MonoRowsTarget::level 0.
constexpr MonoRowsTarget gfx_canvas1(uint8_t* buffer,
                                     int32_t width,
                                     int32_t height) noexcept {
  MonoRowsTarget target;
  target.strip = whole_picture(buffer, PixelFormat::mono_rows, width, height);
  target.order = BitOrder::high_left;
  return target;
}

/// GFXcanvas8: draws 255, or Grey8Target::level.
constexpr Grey8Target gfx_canvas8(uint8_t* buffer,
                                  int32_t width,
                                  int32_t height) noexcept {
  Grey8Target target;
  target.strip = whole_picture(buffer, PixelFormat::grey8, width, height);
  return target;
}

/// GFXcanvas16, in the machine's byte order: draws white, or
/// Rgb565Target::colour. After byteSwap() set Rgb565Target::order to the other
/// order.
inline Rgb565Target gfx_canvas16(uint16_t* buffer,
                                 int32_t width,
                                 int32_t height) noexcept {
  Rgb565Target target;
  target.strip = whole_picture(reinterpret_cast<uint8_t*>(buffer),
                               PixelFormat::rgb565, width, height);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  target.order = ByteOrder::high_first;
#else
  target.order = ByteOrder::low_first;
#endif
  return target;
}

}  // namespace port
}  // namespace inkcell
