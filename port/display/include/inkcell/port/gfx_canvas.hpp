// Canvases of Adafruit_GFX: ours over the memory that getBuffer() returns.
//
// A canvas has the size given to its constructor; setRotation() only affects
// drawing by Adafruit_GFX. `buffer` must outlive ours.
#pragma once

#include <stdint.h>

#include "inkcell/port/grey8.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/picture.hpp"
#include "inkcell/port/rgb565.hpp"

namespace inkcell::port {

/// The machine's.
inline constexpr ByteOrder kNativeOrder = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
                                              ? ByteOrder::high_first
                                              : ByteOrder::low_first;

/// GFXcanvas1: draws 1, or 0 with a level of 0.
inline MonoRowsCanvas gfx_canvas1(uint8_t* buffer,
                                  int32_t width,
                                  int32_t height,
                                  uint8_t level = 1) noexcept {
  return MonoRowsCanvas(
      whole_picture(buffer, PixelFormat::mono_rows, width, height), level);
}

/// GFXcanvas8.
inline Grey8Canvas gfx_canvas8(uint8_t* buffer,
                               int32_t width,
                               int32_t height,
                               uint8_t level = 255) noexcept {
  return Grey8Canvas(whole_picture(buffer, PixelFormat::grey8, width, height),
                     level);
}

/// GFXcanvas16, in the machine's byte order; in the other one after byteSwap().
inline Rgb565Canvas gfx_canvas16(uint16_t* buffer,
                                 int32_t width,
                                 int32_t height,
                                 uint16_t colour = 0xffff,
                                 ByteOrder order = kNativeOrder) noexcept {
  return Rgb565Canvas(whole_picture(reinterpret_cast<uint8_t*>(buffer),
                                    PixelFormat::rgb565, width, height, order),
                      colour);
}

}  // namespace inkcell::port
