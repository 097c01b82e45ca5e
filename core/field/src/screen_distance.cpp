#include "screen_distance.hpp"

#include "base/math.hpp"
#include "base/root.hpp"

namespace inkcell {
namespace detail {
namespace {

// The length of a vector, which is that times 2^log2.
uint32_t length_of(int64_t x, int64_t y, int32_t& log2) noexcept {
  // Components of 15 bits, so that the sum of squares takes 32.
  constexpr int64_t kMost = (1 << 15) - 1;
  for (; x > kMost || x < -kMost || y > kMost || y < -kMost; ++log2) {
    x /= 2;
    y /= 2;
  }
  const auto square = [](int64_t value) noexcept {
    const auto side = static_cast<int32_t>(value);
    return static_cast<uint32_t>(side * side);
  };
  return root_of(square(x) + square(y));
}

}  // namespace

int32_t gain_q15(const Style& style, const Gradient& gradient) noexcept {
  const auto along = [&gradient](const GlyphStep& step) noexcept {
    return (int64_t{gradient.x.raw} * step.x_q20 +
            int64_t{gradient.y.raw} * step.y_q20) >>
           20;
  };
  int32_t own_log2 = 0;
  int32_t log2 = 0;
  const uint32_t own = length_of(gradient.x.raw, gradient.y.raw, own_log2)
                       << own_log2;
  const uint32_t shown =
      length_of(along(style.right()), along(style.up()), log2);
  if (shown == 0) {
    return 1 << 15;
  }
  const uint32_t gain = ((own << 15) / shown) >> log2;
  return max(min(static_cast<int32_t>(gain), 1 << 15), style.least_gain_q15());
}

int32_t screen_distance_q10(const Style& style,
                            FieldSampler& sampler,
                            const FieldPlace& at) noexcept {
  if (!style.is_stretched()) {
    return style.to_px_q10(sampler.distance_q10(at));
  }
  const FieldPoint point = sampler.point(at);
  if (sampler.leaf().samples == nullptr) {
    return sampler.leaf().is_inside ? 32 << 10 : -(32 << 10);
  }
  return (style.to_px_q10(point.distance.raw) *
          gain_q15(style, point.gradient)) >>
         15;
}

}  // namespace detail
}  // namespace inkcell
