// The maps of x and y by which grid fitting moves the points of a glyph.
#pragma once

#include <stdint.h>

#include "inkcell/cpp17.hpp"

namespace inkcell {

/// A monotone piecewise-linear map of one coordinate, from the position of an
/// upright glyph's point at the style's size to its fitted position, both
/// relative to the glyph's origin; x to the right, y up. [px] Beyond the outer
/// knots points shift as the knots do. No knots: the identity.
///
/// Trivial, so that it can lie in RAM that is lent as bytes.
struct __attribute__((may_alias)) AxisMap {
  static constexpr int32_t kMaxKnots = 14;
  static constexpr int32_t kReachQ8 = 127 << 8;
  static constexpr int32_t kNoSlope = 1 << 14;

  struct Knot {
    int16_t from_q8;
    int16_t to_q8;
    int32_t slope_q14;  // up to the next knot; kNoSlope of the last one
  };

  Knot knots[kMaxKnots];  // ascending
  int32_t count;

  void clear() noexcept { count = 0; }

  /// Adds the next higher knot. Where it would go below the one before, it goes
  /// there. False, and nothing is changed, if there are kMaxKnots, if it does
  /// not lie above the one before, or if a number passes +-kReachQ8.
  bool add(int32_t from_q8, int32_t to_q8) noexcept;

  /// The fitted position of a point. `knot` is the index of any knot, below
  /// `count`: one near the point saves time. It becomes the index of the
  /// point's knot. There must be at least one knot.
  int32_t map(int32_t at_q8, int32_t& knot) const noexcept {
    int32_t i = knot;
    while (i + 1 < count && at_q8 >= knots[i + 1].from_q8) {
      ++i;
    }
    while (i > 0 && at_q8 < knots[i].from_q8) {
      --i;
    }
    knot = i;
    const Knot& near = knots[i];
    if (near.slope_q14 == kNoSlope || at_q8 < near.from_q8) {
      // Points of hostile fonts lie anywhere: modulo 2^32.
      return static_cast<int32_t>(
          static_cast<uint32_t>(at_q8) +
          static_cast<uint32_t>(near.to_q8 - near.from_q8));
    }
    // Less than the way to the next knot, 2^16, in Q14.
    return near.to_q8 + ((at_q8 - near.from_q8) * near.slope_q14 >> 14);
  }
  int32_t map(int32_t at_q8) const noexcept {
    int32_t knot = 0;
    return count == 0 ? at_q8 : map(at_q8, knot);
  }
};

/// The maps of both coordinates.
struct __attribute__((may_alias)) GlyphWarp {
  AxisMap x;
  AxisMap y;

  void clear() noexcept {
    x.clear();
    y.clear();
  }
};

}  // namespace inkcell
