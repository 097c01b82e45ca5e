#include "inkcell/glyph_warp.hpp"

namespace inkcell {

bool AxisMap::add(int32_t from_q8, int32_t to_q8) noexcept {
  const auto is_near = [](int32_t value) noexcept {
    return static_cast<uint32_t>(value + kReachQ8) <= 2 * kReachQ8;
  };
  if (count >= kMaxKnots || !is_near(from_q8) || !is_near(to_q8)) {
    return false;
  }
  if (count != 0) {
    Knot& last = knots[count - 1];
    const int32_t length = from_q8 - last.from_q8;
    if (length <= 0) {
      return false;
    }
    to_q8 = to_q8 < last.to_q8 ? last.to_q8 : to_q8;
    // At most 2^30. Rounded down, so that no point passes the knot.
    last.slope_q14 =
        static_cast<int32_t>((static_cast<uint32_t>(to_q8 - last.to_q8) << 14) /
                             static_cast<uint32_t>(length));
  }
  knots[count] = {static_cast<int16_t>(from_q8), static_cast<int16_t>(to_q8),
                  kNoSlope};
  ++count;
  return true;
}

}  // namespace inkcell
