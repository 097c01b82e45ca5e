// Pixel formats: the bytes that a strip needs, and the blend of all formats.
//
// Each format has a header of its own with a canvas (canvas.hpp):
//
//   a8.hpp          A8Canvas         coverage itself, 8 bit
//   grey8.hpp       Grey8Canvas      256 levels
//   grey4.hpp       Grey4Canvas      16 levels, either nibble first
//   grey2.hpp       Grey2Canvas      4 levels, either end first
//   mono_rows.hpp   MonoRowsCanvas   1 bit, bytes along the row
//   mono_pages.hpp  MonoPagesCanvas  1 bit, bytes of 8 rows, bit 0 on top
//   rgb565.hpp      Rgb565Canvas     either byte first
//   rgb888.hpp      Rgb888Canvas     3 bytes, red or blue first
//   xrgb8888.hpp    Xrgb8888Canvas   4 bytes: blue, green, red, x
//
// lcd.hpp adds LCD sub-pixels to colour canvases, dither.hpp dither to those
// of 1, 2 and 4 bits.
//
// The colour may change between two draw calls. Canvas::status() is ok, or:
//
//   bad_argument  a negative size; a size or the distance of a corner from the
//                 origin over 32767 px; or a stride shorter than a row or over
//                 65535 bytes: the window is empty
//   misaligned    only xrgb8888: pixels or stride not a multiple of 4 bytes:
//                 the window is empty
//   buffer_small  fewer bytes than the rows need: the window has the rows that
//                 they hold
//
// A canvas never writes outside of its strip, whatever its arguments, and never
// changes a pixel of coverage 0.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// Formats of the pixels of a strip; canvases are named after them.
enum class PixelFormat : uint8_t {
  a8,
  grey8,
  grey4,
  grey2,
  mono_rows,
  mono_pages,
  rgb565,
  rgb888,
  xrgb8888,
};

/// The end of a byte that holds the left pixel, in formats of several pixels a
/// byte.
enum class BitOrder : uint8_t { high_left, low_left };

constexpr int32_t bits_per_pixel(PixelFormat format) noexcept {
  switch (format) {
    case PixelFormat::mono_rows:
    case PixelFormat::mono_pages:
      return 1;
    case PixelFormat::grey2:
      return 2;
    case PixelFormat::grey4:
      return 4;
    case PixelFormat::a8:
    case PixelFormat::grey8:
      return 8;
    case PixelFormat::rgb565:
      return 16;
    case PixelFormat::rgb888:
      return 24;
    case PixelFormat::xrgb8888:
      return 32;
  }
  return 8;  // of what is no format
}

/// The longest side of a strip. [px]
inline constexpr int32_t kMaxSide = 32767;

namespace detail {

constexpr int32_t clamp_side(int32_t px) noexcept {
  return px < 0 ? 0 : (px > kMaxSide ? kMaxSide : px);
}

}  // namespace detail

/// The smallest Strip::stride [bytes] for `width` px: a row, or in mono_pages a
/// page of 8 rows. The width is clamped to 0..32767 px.
constexpr int32_t stride_bytes(PixelFormat format, int32_t width) noexcept {
  const int32_t pixels = detail::clamp_side(width);
  return format == PixelFormat::mono_pages
             ? pixels
             : (pixels * bits_per_pixel(format) + 7) / 8;
}

/// Rows in a stride: 8 in mono_pages, else 1.
constexpr int32_t rows_per_stride(PixelFormat format) noexcept {
  return format == PixelFormat::mono_pages ? 8 : 1;
}

/// The bytes of a strip of `width` x `height` px with that stride. Both are
/// clamped as in stride_bytes().
constexpr size_t strip_bytes(PixelFormat format,
                             int32_t width,
                             int32_t height) noexcept {
  const int32_t per_stride = rows_per_stride(format);
  const int32_t strides =
      (detail::clamp_side(height) + per_stride - 1) / per_stride;
  return static_cast<size_t>(stride_bytes(format, width)) *
         static_cast<size_t>(strides);
}

/// Whether `strip` can hold pixels of `format`; else what Canvas::status() is.
Status check_strip(const Strip& strip, PixelFormat format) noexcept;

/// value / 255 to the nearest integer, exact for 0..65535. There are no ties:
/// 255 is odd.
constexpr uint32_t divide_by_255(uint32_t value) noexcept {
  return (value + 128 + ((value + 128) >> 8)) >> 8;
}

/// `foreground` over `background`, both 0..255 or on any shallower scale: (c *
/// foreground + (255 - c) * background) / 255 to the nearest. All formats but
/// RGB565 blend each channel so, in the levels that they store.
constexpr uint32_t blend(uint32_t coverage,
                         uint32_t foreground,
                         uint32_t background) noexcept {
  return divide_by_255(coverage * foreground + (255 - coverage) * background);
}

}  // namespace inkcell::port
