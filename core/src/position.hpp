// Where pixels lie in a glyph.
#pragma once

#include <stdint.h>

#include "field_draw.hpp"
#include "inkcell/brush.hpp"
#include "inkcell/render.hpp"

namespace inkcell {
namespace detail {

inline int64_t clamp(int64_t value, int64_t low, int64_t high) noexcept {
  if (value < low) {
    return low;
  }
  return value > high ? high : value;
}

inline int32_t clamp_i32(int64_t value) noexcept {
  return static_cast<int32_t>(clamp(value, INT32_MIN, INT32_MAX));
}

// How far one pixel to the right leads in px along the glyph's axes. [Q20]
inline int32_t along_q20(const Brush& brush) noexcept {
  return brush.direction().cosine.raw >> 10;
}
inline int32_t across_q20(const Brush& brush) noexcept {
  return brush.direction().sine.raw >> 10;
}

// Where the centre of pixel (x, y) lies in the glyph.
//
// Linear in x and y with whole steps: neighbours differ by exactly the brush's
// step, so that it does not matter where a row or a strip begins. Within the
// box of a field positions in u stay below 2^31: its grid ends at 15360 u,
// twice that in a corner of the box around a turned grid.
inline FieldPosition position_of(const Brush& brush,
                                 const FinePoint& origin,
                                 int32_t x,
                                 int32_t y) noexcept {
  // Far from anything to see, but within 64 bits once multiplied.
  constexpr int64_t kFar = int64_t{1} << 37;
  const int64_t right =
      clamp(int64_t{x} * 1024 + 512 - origin.x_q10, -kFar, kFar);
  const int64_t up =
      clamp(origin.y_q10 - (int64_t{y} * 1024 + 512), -kFar, kFar);
  const int64_t along = brush.step_along_q16();
  constexpr int64_t kHalf = kHalfQ20;
  if (brush.is_upright()) {
    return {clamp_i32((right * along) >> 10), clamp_i32((up * along) >> 10),
            static_cast<uint32_t>(right * 1024 + kHalf),
            static_cast<uint32_t>(up * 1024 + kHalf)};
  }
  const int64_t across = brush.step_across_q16();
  const int64_t along_px = along_q20(brush);
  const int64_t across_px = across_q20(brush);
  return {clamp_i32((right * along + up * across) >> 10),
          clamp_i32((up * along - right * across) >> 10),
          static_cast<uint32_t>(((right * along_px + up * across_px) >> 10) +
                                kHalf),
          static_cast<uint32_t>(((up * along_px - right * across_px) >> 10) +
                                kHalf)};
}

}  // namespace detail
}  // namespace inkcell
