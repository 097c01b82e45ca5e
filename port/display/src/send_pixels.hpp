// The pixels of a strip, in the fewest transfers.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/port/display_bus.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// Sends all rows, or pages, of a strip that check_on_screen() accepts: in one
/// transfer if there are no gaps between them.
inline void send_pixels(const DisplayBus& bus,
                        const Strip& strip,
                        PixelFormat format) noexcept {
  const auto send = bus.start != nullptr ? bus.start : bus.data;
  const int32_t row_bytes = stride_bytes(format, strip.width);
  const int32_t rows = strip.height / rows_per_stride(format);
  const uint8_t* row = strip.pixels.data;
  if (row_bytes == strip.stride) {
    send(bus.context, row, static_cast<size_t>(row_bytes * rows));
    return;
  }
  for (int32_t y = 0; y < rows; ++y, row += strip.stride) {
    send(bus.context, row, static_cast<size_t>(row_bytes));
  }
}

}  // namespace inkcell::port
