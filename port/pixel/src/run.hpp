// What all sinks begin with: checking a strip, and clipping a run to it.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {
namespace detail {

/// Pixels of one row, from (x, y) to the right.
struct Run {
  int32_t x;
  int32_t y;
  int32_t count;
  int32_t skipped;  // pixels cut off on the left
};

/// clip() for any run.
bool clip_any(const Strip& strip, Run& run) noexcept;

/// Cuts `run` (screen) to the strip and makes it relative to the strip's first
/// pixel. Returns whether anything is left. Safe for any values.
inline bool clip(const Strip& strip, Run& run) noexcept {
  // What the core draws lies in the strip.
  const uint32_t x =
      static_cast<uint32_t>(run.x) - static_cast<uint32_t>(strip.x0);
  const uint32_t y =
      static_cast<uint32_t>(run.y) - static_cast<uint32_t>(strip.y0);
  const auto width = static_cast<uint32_t>(strip.width);
  const auto count = static_cast<uint32_t>(run.count);
  if (y >= static_cast<uint32_t>(strip.height) || x >= width || count == 0 ||
      count > width - x) {
    return clip_any(strip, run);
  }
  run.x = static_cast<int32_t>(x);
  run.y = static_cast<int32_t>(y);
  return true;
}

/// Makes the sink of `strip` from the two functions and their context, if
/// check_strip() agrees.
Status open_sink(const Strip& strip,
                 PixelFormat format,
                 const Sink& functions,
                 Sink& out) noexcept;

/// The first byte of row (or page) `y` of the strip.
inline uint8_t* row_at(const Strip& strip, int32_t y) noexcept {
  return strip.pixels.data +
         static_cast<size_t>(y) * static_cast<size_t>(strip.stride);
}

}  // namespace detail
}  // namespace port
}  // namespace inkcell
