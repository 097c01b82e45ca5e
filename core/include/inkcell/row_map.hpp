// How rows of pixels map to heights in a glyph: what grid fitting changes.
#pragma once

#include <stdint.h>

namespace inkcell {

/// A monotone piecewise-linear map from heights on the screen to heights in the
/// glyph as it was designed, both in px above the baseline, y up. Beyond the
/// outer knots it shifts as they do. No knots: the identity.
///
/// Distances stay what they are in the glyph: no point is moved by more than
/// 1 px.
struct RowMap {
  static constexpr int32_t kMaxKnots = 10;
  static constexpr int32_t kMaxShiftQ10 = 1 << 10;
  static constexpr int32_t kLeastStepQ10 = 16;
  static constexpr int32_t kReachQ10 = 512 << 10;

  struct Knot {
    int32_t screen_q10;  // [px]
    int32_t glyph_q10;   // [px]
    // What the slope up to the next knot has above 1; 0 of the highest.
    int32_t excess_q16;

    /// The height in the glyph that the screen shows at `at_q10`: above the
    /// knot and below the next, or below the lowest. [px]
    int32_t height_at(int32_t at_q10) const noexcept {
      const int32_t above = at_q10 - screen_q10;
      // Between two knots the product is at most 2^11 in Q16. Beyond the outer
      // ones the map shifts as they do.
      return glyph_q10 + above + (above > 0 ? (above * excess_q16) >> 16 : 0);
    }
  };

  /// From low to high; `add` makes them.
  Knot knots[kMaxKnots];
  uint8_t count = 0;

  /// Adds the next higher knot. False, and nothing is changed, if there are
  /// kMaxKnots, if the heights are not kLeastStepQ10 above those of the last
  /// one, if they differ by more than kMaxShiftQ10, or pass +-kReachQ10.
  bool add(int32_t screen_q10, int32_t glyph_q10) noexcept;

  /// The height in the glyph that the screen shows at `screen_q10`, within
  /// +-2^20 px. [px, Q10 -> Q10]
  int32_t glyph_height_q10(int32_t screen_q10) const noexcept {
    return count == 0
               ? screen_q10
               : knot_below(screen_q10, highest())->height_at(screen_q10);
  }

  /// There must be knots.
  const Knot* highest() const noexcept { return knots + count - 1; }

  /// The knot that tells height_at(screen_q10): `from` or one below it.
  const Knot* knot_below(int32_t screen_q10, const Knot* from) const noexcept {
    while (from != knots && from->screen_q10 > screen_q10) {
      --from;
    }
    return from;
  }
};

}  // namespace inkcell
