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

  struct Knot {
    int32_t screen_q10;  // [px]
    int32_t glyph_q10;   // [px]
  };

  /// Both heights increase from knot to knot by 1/64 px at least, and differ by
  /// kMaxShiftQ10 at the most.
  Knot knots[kMaxKnots];
  uint8_t count = 0;

  /// The height in the glyph that the screen shows at `screen_q10`, within
  /// +-2^20 px. [px, Q10 -> Q10]
  int32_t glyph_height_q10(int32_t screen_q10) const noexcept;
};

}  // namespace inkcell
