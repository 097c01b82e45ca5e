#include "inkcell/row_map.hpp"

namespace inkcell {
namespace {

bool is_within(int32_t value, int32_t limit) noexcept {
  return value >= -limit && value <= limit;
}

// The quotient rounded towards minus infinity; `divisor` is positive.
int32_t divide_down(int32_t dividend, int32_t divisor) noexcept {
  const int32_t towards_zero = dividend / divisor;
  return dividend < towards_zero * divisor ? towards_zero - 1 : towards_zero;
}

}  // namespace

bool RowMap::add(int32_t screen_q10, int32_t glyph_q10) noexcept {
  if (count >= kMaxKnots || !is_within(screen_q10, kReachQ10) ||
      !is_within(glyph_q10, kReachQ10) ||
      !is_within(glyph_q10 - screen_q10, kMaxShiftQ10)) {
    return false;
  }
  if (count != 0) {
    Knot& last = knots[count - 1];
    const int32_t step = screen_q10 - last.screen_q10;
    const int32_t glyph_step = glyph_q10 - last.glyph_q10;
    if (step < kLeastStepQ10 || glyph_step < kLeastStepQ10) {
      return false;
    }
    // 2^11 at the most in Q16. Rounded down, so that the map does not pass the
    // upper knot. Strokes are often 1 px wide, which takes no division.
    const int32_t excess = glyph_step - step;
    last.excess_q16 = step == 1 << 10 ? excess * (1 << 6)
                                      : divide_down(excess * (1 << 16), step);
  }
  knots[count] = {screen_q10, glyph_q10, 0};
  ++count;
  return true;
}

}  // namespace inkcell
