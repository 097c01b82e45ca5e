#include "inkcell/shadow.hpp"

#include "base/math.hpp"

namespace inkcell {

Status check_reach(const FontRange& range,
                   Q26_6 size,
                   const Filter& filter) noexcept {
  const int32_t reach_q10 = detail::max(-filter.outside_q10, filter.inside_q10);
  // The band is 1/1024 em, so that both sides are 1/1024 px, Q6.
  return int64_t{reach_q10} * 64 > (int64_t{range.band_u} + 1) * size.raw
             ? Status::beyond_band
             : Status::ok;
}

}  // namespace inkcell
