// Lengths and roundings of grid fitting. All lengths are [px, Q6] unless their
// names say otherwise.
#pragma once

#include <stdint.h>

#include "base/math.hpp"

namespace inkcell::detail {

constexpr int32_t kPx = 1 << 6;

// The least width of strokes on displays with many levels, and the least gap
// beside bars.
constexpr int32_t kLeastStroke = 48;

inline int32_t round_px(int32_t value) noexcept {
  return (value + kPx / 2) & ~(kPx - 1);
}

// Snaps the width of a stroke to the common width if it is close.
__attribute__((noinline)) inline int32_t common_width(int32_t width,
                                                      int32_t most) noexcept {
  return abs(width - most) < max(16, most * 77 >> 8) ? most : width;
}

__attribute__((noinline)) inline int32_t whole_width(int32_t width) noexcept {
  return max(kPx, round_px(width));
}

}  // namespace inkcell::detail
