// Lengths and roundings of grid fitting. All lengths are [px, Q6] unless their
// names say otherwise.
#pragma once

#include <stdint.h>

#include "base/math.hpp"

namespace inkcell {
namespace detail {

constexpr int32_t kPx = 1 << 6;

// Strokes of displays with many levels are no thinner; and the room that is
// left beside bars.
constexpr int32_t kLeastStroke = 48;

inline int32_t round_px(int32_t value) noexcept {
  return (value + kPx / 2) & ~(kPx - 1);
}

// A stroke about as wide as most are is as wide as they are.
__attribute__((noinline)) inline int32_t common_width(int32_t width,
                                                      int32_t most) noexcept {
  return abs(width - most) < max(16, most * 77 >> 8) ? most : width;
}

__attribute__((noinline)) inline int32_t whole_width(int32_t width) noexcept {
  return max(kPx, round_px(width));
}

}  // namespace detail
}  // namespace inkcell
