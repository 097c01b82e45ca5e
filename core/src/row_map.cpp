#include "inkcell/row_map.hpp"

namespace inkcell {

int32_t RowMap::glyph_height_q10(int32_t screen_q10) const noexcept {
  int32_t above = 0;
  while (above < count && knots[above].screen_q10 <= screen_q10) {
    ++above;
  }
  if (count == 0) {
    return screen_q10;
  }
  if (above == 0 || above == count) {
    const Knot& end = knots[above == 0 ? 0 : count - 1];
    return screen_q10 + (end.glyph_q10 - end.screen_q10);
  }
  const Knot& low = knots[above - 1];
  const Knot& high = knots[above];
  // One division a row: heights between knots are at most a few em.
  const int64_t way =
      int64_t{screen_q10 - low.screen_q10} * (high.glyph_q10 - low.glyph_q10);
  return low.glyph_q10 +
         static_cast<int32_t>(way / (high.screen_q10 - low.screen_q10));
}

}  // namespace inkcell
