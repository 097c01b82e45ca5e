// Shared by all sinks: clips a run to its strip.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/port/canvas.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port::detail {

/// Pixels of one row, from (x, y) to the right.
struct Run {
  int32_t x;
  int32_t y;
  int32_t count;
  int32_t skipped;  // pixels cut off on the left
};

/// Clips `run` (screen) to the strip and makes it relative to the strip's first
/// pixel. Returns whether anything is left. Safe for any values; a run that
/// begins 2^31 px or more away from the strip may show.
inline bool clip(const Strip& strip, Run& run) noexcept {
  // Modulo 2^32.
  const uint32_t x =
      static_cast<uint32_t>(run.x) - static_cast<uint32_t>(strip.x0);
  const uint32_t y =
      static_cast<uint32_t>(run.y) - static_cast<uint32_t>(strip.y0);
  run.x = static_cast<int32_t>(x);
  run.y = static_cast<int32_t>(y);
  if (y >= static_cast<uint32_t>(strip.height)) {
    return false;
  }
  if (__builtin_expect(run.x < 0, 0)) {
    if (run.count <= 0) {
      return false;
    }
    run.count += run.x;
    run.skipped = static_cast<int32_t>(0u - x);
    run.x = 0;
  }
  const int32_t room = strip.width - run.x;
  if (run.count > room) {
    run.count = room;
  }
  return run.count > 0;
}

/// Sink::coverage of a format: `draw` gets what is left of the run, relative to
/// the strip. A pixel has kChannels bytes of coverage.
template <typename Pixels,
          void (*draw)(const Pixels&, const Run&, const uint8_t*) noexcept,
          int kChannels = 1>
void coverage_of(void* context,
                 int32_t x,
                 int32_t y,
                 const uint8_t* coverage,
                 int32_t count) noexcept {
  const auto& pixels = *static_cast<const Pixels*>(context);
  Run run{x, y, count, 0};
  if (clip(pixels.strip, run)) {
    draw(pixels, run, coverage + kChannels * run.skipped);
  }
}

/// Likewise Sink::solid.
template <typename Pixels, void (*draw)(const Pixels&, const Run&) noexcept>
void solid_of(void* context, int32_t x, int32_t y, int32_t count) noexcept {
  const auto& pixels = *static_cast<const Pixels*>(context);
  Run run{x, y, count, 0};
  if (clip(pixels.strip, run)) {
    draw(pixels, run);
  }
}

/// Clips `block` to the strip. Returns whether anything is left.
inline bool clip(const Strip& strip, CoverageBlock& block) noexcept {
  const Rect pixels = intersect(block.pixels, strip.rect());
  block.coverage += (pixels.y0 - block.pixels.y0) * block.stride +
                    (pixels.x0 - block.pixels.x0);
  block.pixels = pixels;
  return !is_empty(pixels);
}

constexpr Layout layout_of(PixelFormat format) noexcept {
  return rows_per_stride(format) == 1
             ? Layout{static_cast<uint8_t>(bits_per_pixel(format)), 0}
             : Layout{8, 3};
}

/// The first byte of row (or page) `y` of the strip.
inline uint8_t* row_at(const Strip& strip, int32_t y) noexcept {
  return strip.pixels.data +
         static_cast<size_t>(y) * static_cast<size_t>(strip.stride);
}

}  // namespace inkcell::port::detail
