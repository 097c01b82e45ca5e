// A display that shows a piece of memory: strips are copied to their place.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// The memory that a display controller reads; owned by the board. Strips have
/// the same format. With RAM for a whole picture one may as well draw there
/// without copying: a strip can be any part of the framebuffer.
struct Framebuffer {
  Span<uint8_t> pixels;
  PixelFormat format = PixelFormat::rgb565;
  int32_t width = 0;   // [px]
  int32_t height = 0;  // [px]
  int32_t stride = 0;  // [bytes] from one row, or page of 8 rows, to the next
};

/// Copies a strip to its place on the screen.
///
/// bad_argument: the strip does not lie on the screen, its edges are not edges
/// of bytes, or a stride is shorter than a row. buffer_small: strip or
/// framebuffer has fewer pixels than its rows need. Nothing is copied then.
Status write(const Framebuffer& display, const Strip& strip) noexcept;

}  // namespace port
}  // namespace inkcell
