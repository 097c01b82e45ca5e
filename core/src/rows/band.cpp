#include "rows/band.hpp"

namespace inkcell::detail {

const ScreenPoint* skip_outside(const Band& band,
                                const ScreenPoint* at,
                                const ScreenPoint* end) noexcept {
  // Heights and kinds are compared as they lie in RAM.
  const int32_t above = (band.y_q8 - kAboveBand) * 4;
  const int32_t below = (band.y_q8 + band.rows * 256 + kBelowBand) * 4 + 3;
  const ScreenPoint* last = at;
  if (at->y_q8_kind < above) {
    while (++at != end && at->y_q8_kind < above) {
      last = at->kind() == kOffCurve ? last : at;
    }
  } else if (at->y_q8_kind > below) {
    while (++at != end && at->y_q8_kind > below) {
      last = at->kind() == kOffCurve ? last : at;
    }
  }
  return last;
}

}  // namespace inkcell::detail
