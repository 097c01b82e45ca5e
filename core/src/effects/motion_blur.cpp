#include "inkcell/motion_blur.hpp"

#include "base/math.hpp"

namespace inkcell {

using detail::abs;

Status make_motion_blur(const Filter& filter,
                        Point way,
                        MotionBlur& out) noexcept {
  constexpr int32_t kMost = 32 << 6;
  if (way.x.raw > kMost || way.x.raw < -kMost || way.y.raw > kMost ||
      way.y.raw < -kMost) {
    return Status::bad_argument;
  }
  const int32_t x = abs(way.x.raw);
  const int32_t y = abs(way.y.raw);
  // From the length to 3/2 of it; steps are no longer than a pixel along an
  // axis.
  const int32_t longer = x > y ? x : y;
  const int32_t steps = longer <= 64 ? 1 : (longer + 63) >> 6;
  out.filter = filter;
  uint32_t sum = 0;
  for (int32_t i = 0; i < Filter::kEntries; ++i) {
    out.sums[i] = static_cast<uint16_t>(sum);
    sum += filter.table[i];
  }
  out.sums[Filter::kEntries] = static_cast<uint16_t>(sum);
  out.steps = static_cast<uint8_t>(steps);
  out.right_q10 = way.x.raw * 16 / steps;
  out.up_q10 = -way.y.raw * 16 / steps;
  out.length_q10 = (x + y) * 16 / steps;
  out.reach_px = static_cast<uint8_t>((longer >> 7) + 1);
  return Status::ok;
}

}  // namespace inkcell
