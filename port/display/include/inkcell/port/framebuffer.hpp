// A display that shows a part of memory: strips are copied to their place.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// The memory that a display controller reads; owned by the board. Strips have
/// the same format. Instead of copying, a program can also draw directly: any
/// part of the framebuffer can be a strip.
struct Framebuffer {
  Span<uint8_t> pixels;
  PixelFormat format = PixelFormat::rgb565;
  int32_t width = 0;   // [px]
  int32_t height = 0;  // [px]
  int32_t stride = 0;  // [bytes] from one row, or page of 8 rows, to the next
};

/// Copies a strip to its place on the screen.
///
/// bad_argument: the strip is not on the screen, its edges are inside bytes, or
/// a stride is shorter than a row. buffer_small: strip or framebuffer has fewer
/// pixels than its rows need. Nothing is copied then.
Status write(const Framebuffer& display, const Strip& strip) noexcept;

}  // namespace inkcell::port
