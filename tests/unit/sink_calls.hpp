// The functions of a mock sink: what they are given goes to one function of
// the mock, put(x, y, coverage, count), with null for full coverage.
#pragma once

#include <stdint.h>

#include "check.hpp"
#include "inkcell/strip.hpp"

/// For a `Mock` that derives from it and is the context of its sinks.
template <typename Mock>
struct SinkCalls {
  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* values,
                       int32_t count) {
    CHECK(count <= inkcell::kMaxSpan);
    static_cast<Mock*>(context)->put(x, y, values, count);
  }
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    static_cast<Mock*>(context)->put(x, y, nullptr, count);
  }
  static void block(void* context, const inkcell::CoverageBlock& block) {
    const inkcell::Rect& part = block.pixels;
    CHECK_EQ(block.stride % 4, 0);
    CHECK_EQ((reinterpret_cast<uintptr_t>(block.coverage) -
              static_cast<uintptr_t>(part.x0)) %
                 4,
             0u);
    for (int32_t y = part.y0; y != part.y1; ++y) {
      static_cast<Mock*>(context)->put(
          part.x0, y, block.coverage + (y - part.y0) * block.stride,
          part.x1 - part.x0);
    }
  }

 protected:
  /// Whether a call is one that a sink of `window` may get.
  static bool fits(const inkcell::Rect& window,
                   int32_t x,
                   int32_t y,
                   int32_t count) {
    const bool fits = count >= 1 && y >= window.y0 && y < window.y1 &&
                      x >= window.x0 && count <= window.x1 - x;
    CHECK(fits && "pixels inside the window");
    return fits;
  }
};
