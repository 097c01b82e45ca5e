// Strips copied into a framebuffer, row by row.
#include "inkcell/port/framebuffer.hpp"

#include "bounds.hpp"

namespace inkcell::port {

Status write(const Framebuffer& display, const Strip& strip) noexcept {
  INKCELL_TRY(
      check_on_screen(strip, display.format, display.width, display.height));
  const Strip whole = {display.pixels, 0, 0, display.width, display.height,
                       display.stride};
  INKCELL_TRY(
      check_on_screen(whole, display.format, display.width, display.height));

  const bool pages = display.format == PixelFormat::mono_pages;
  const int32_t left =
      pages ? strip.x0 : strip.x0 * bits_per_pixel(display.format) / 8;
  const int32_t rows = pages ? strip.height / 8 : strip.height;
  const int32_t top = pages ? strip.y0 / 8 : strip.y0;
  const size_t row_bytes =
      static_cast<size_t>(stride_bytes(display.format, strip.width));
  uint8_t* to = display.pixels.data + top * display.stride + left;
  const uint8_t* from = strip.pixels.data;
  for (int32_t y = 0; y < rows; ++y) {
    __builtin_memcpy(to, from, row_bytes);
    to += display.stride;
    from += strip.stride;
  }
  return Status::ok;
}

}  // namespace inkcell::port
