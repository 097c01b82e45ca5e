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

/// How many of `count` pixels to the right of (x, y), counted from the strip's
/// first pixel, lie in it.
int32_t count_within(const Strip& strip,
                     int32_t x,
                     int32_t y,
                     int32_t count) noexcept;

/// Cuts `run` (screen) to the strip and makes it relative to the strip's first
/// pixel. Returns whether anything is left. Safe for any values.
inline bool clip(const Strip& strip, Run& run) noexcept {
  // Differences modulo 2^32. The strip's corner is near, so they wrap only for
  // what is some 2^31 px away, and are too large then.
  const uint32_t x =
      static_cast<uint32_t>(run.x) - static_cast<uint32_t>(strip.x0);
  const uint32_t y =
      static_cast<uint32_t>(run.y) - static_cast<uint32_t>(strip.y0);
  const auto width = static_cast<uint32_t>(strip.width);
  const auto count = static_cast<uint32_t>(run.count);
  run.x = static_cast<int32_t>(x);
  run.y = static_cast<int32_t>(y);
  // What the core draws lies in the strip.
  if (y >= static_cast<uint32_t>(strip.height) || x >= width ||
      count - 1 >= width - x) {
    run.count = count_within(strip, run.x, run.y, run.count);
    if (run.x < 0) {
      run.skipped = -run.x;
      run.x = 0;
    }
    return run.count != 0;
  }
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
