// Where glyphs stand.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "inkcell/geometry.hpp"

namespace inkcell::detail {

// Where a glyph stands: an origin that is near enough to show something.
// Windows lie within 2^15 px, and no glyph reaches farther than 2^16 px. [Q10]
struct Placed {
  static constexpr int32_t kLimit = 1 << 30;

  int32_t x_q10;
  int32_t y_q10;

  FinePoint origin() const noexcept { return {x_q10, y_q10}; }

  // False: the origin is too far.
  bool set(const FinePoint& at) noexcept {
    x_q10 = static_cast<int32_t>(at.x_q10);
    y_q10 = static_cast<int32_t>(at.y_q10);
    constexpr uint64_t kAll = uint64_t{2} * kLimit;
    return static_cast<uint64_t>(at.x_q10) + kLimit < kAll &&
           static_cast<uint64_t>(at.y_q10) + kLimit < kAll;
  }
  // The same without 64 bits.
  bool set(Point at) noexcept {
    const auto x_q6 = static_cast<uint32_t>(at.x.raw);
    const auto y_q6 = static_cast<uint32_t>(at.y.raw);
    x_q10 = wrapped(x_q6 * 16);
    y_q10 = wrapped(y_q6 * 16);
    constexpr uint32_t kLimitQ6 = kLimit / 16;
    return x_q6 + kLimitQ6 < 2 * kLimitQ6 && y_q6 + kLimitQ6 < 2 * kLimitQ6;
  }
};

}  // namespace inkcell::detail
