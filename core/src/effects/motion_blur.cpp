#include "inkcell/motion_blur.hpp"

#include "base/math.hpp"

namespace inkcell {

using detail::abs;
using detail::max;

Status make_motion_blur(Point way, MotionBlur& out) noexcept {
  constexpr int32_t kMost = 32 << 6;
  if (way.x.raw > kMost || way.x.raw < -kMost || way.y.raw > kMost ||
      way.y.raw < -kMost) {
    return Status::bad_argument;
  }
  const int32_t longer = max(abs(way.x.raw), abs(way.y.raw));
  const int32_t steps = longer <= 64 ? 1 : (longer + 63) >> 6;
  out.steps = static_cast<uint8_t>(steps);
  out.right_q10 = way.x.raw * 16 / steps;
  out.up_q10 = -way.y.raw * 16 / steps;
  out.reach_px = static_cast<uint8_t>((longer >> 7) + 1);
  return Status::ok;
}

}  // namespace inkcell
