// Motion blur: pictures along the path of the glyph, half a pixel apart or
// less, so that the squares of pixels leave no gaps between them.
#include "inkcell/motion_blur.hpp"

#include "base/math.hpp"
#include "effects/mean.hpp"

namespace inkcell {
namespace detail {
namespace {

const MotionBlur& blur_of(const Style& style) noexcept {
  return *static_cast<const MotionBlur*>(style.effect().options);
}

void plan_blur(const Style& style, BandPlan& plan) noexcept {
  const MotionBlur& blur = blur_of(style);
  const auto half_q8 = [&blur](int32_t step_q10) noexcept {
    return static_cast<int16_t>((abs(step_q10) * blur.steps >> 3) + 1);
  };
  plan.sample_bytes = Mean::kSampleBytes;
  plan.moved_x_q8 = half_q8(blur.right_q10);
  plan.moved_y_q8 = half_q8(blur.up_q10);
}

// Two pictures a step and one in the middle, each in the middle of an equal
// part of the path.
void mix_blurred(GlyphJob& job) noexcept {
  const MotionBlur& blur = blur_of(*job.style);
  const int32_t steps = blur.steps;
  const int32_t count = 2 * steps + 1;
  const auto share = [count](int32_t i) noexcept {
    return static_cast<uint32_t>((i + 1) * 256 / count - i * 256 / count);
  };
  Mean mean(job);
  mean.add(share(steps));
  for (int32_t i = 0; i != count; ++i) {
    if (i != steps) {
      const int32_t parts = (i - steps) * steps;
      mean.add(parts * blur.right_q10 / (4 * count),
               -parts * blur.up_q10 / (4 * count), share(i));
    }
  }
  mean.emit();
}

}  // namespace

const Mixer kMotionBlurMixer = {nullptr, plan_blur, mix_blurred};

}  // namespace detail

Status make_motion_blur(Point path, MotionBlur& out) noexcept {
  constexpr int32_t kMost = 32 << 6;
  if (path.x.raw > kMost || path.x.raw < -kMost || path.y.raw > kMost ||
      path.y.raw < -kMost) {
    return Status::bad_argument;
  }
  const int32_t longer =
      detail::max(detail::abs(path.x.raw), detail::abs(path.y.raw));
  const int32_t steps = longer <= 64 ? 1 : (longer + 63) >> 6;
  out.steps = static_cast<uint8_t>(steps);
  out.right_q10 = path.x.raw * 16 / steps;
  out.up_q10 = -path.y.raw * 16 / steps;
  out.reach_px = static_cast<uint8_t>((longer >> 7) + 1);
  return Status::ok;
}

}  // namespace inkcell
