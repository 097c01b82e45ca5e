// The buffer of U8g2: a canvas over the memory that getBufferPtr() returns.
//
// For U8g2's page layout, used by SSD1306, SH1106 and most displays. For
// displays whose bytes run along the row use MonoRowsCanvas.
#pragma once

#include <stdint.h>

#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/picture.hpp"

namespace inkcell::port {

/// Draws 1, or 0 after set_level(0). `buffer` has tiles of 8 x 8 px:
/// getBufferTileWidth() by getBufferTileHeight(). `first_tile_row` is 0 for a
/// full buffer, and getBufferCurrTileRow() within nextPage(). `buffer` must
/// outlive the canvas.
inline MonoPagesCanvas u8g2_buffer(uint8_t* buffer,
                                   int32_t tile_width,
                                   int32_t tile_height,
                                   int32_t first_tile_row = 0) noexcept {
  Strip strip = whole_picture(buffer, PixelFormat::mono_pages, 8 * tile_width,
                              8 * tile_height);
  strip.y0 = 8 * first_tile_row;
  return MonoPagesCanvas(strip);
}

}  // namespace inkcell::port
