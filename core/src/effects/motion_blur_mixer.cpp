// Motion blur of outlines: pictures along the way of the glyph, half a pixel
// apart or less, so that the squares of pixels leave no gaps between them.
#include "base/math.hpp"
#include "effects/mean.hpp"
#include "inkcell/motion_blur.hpp"

namespace inkcell {
namespace detail {
namespace {

const MotionBlur& blur_of(const TextStyle& style) noexcept {
  return *static_cast<const MotionBlur*>(style.effect().options);
}

void plan_blur(const TextStyle& style, BandPlan& plan) noexcept {
  const MotionBlur& blur = blur_of(style);
  const auto half_q8 = [&blur](int32_t step_q10) noexcept {
    return static_cast<int16_t>((abs(step_q10) * blur.steps >> 3) + 1);
  };
  plan.sample_bytes = Mean::kSampleBytes;
  plan.moved_x_q8 = half_q8(blur.right_q10);
  plan.moved_y_q8 = half_q8(blur.up_q10);
}

// Two pictures a step and one in the middle, each in the middle of an equal
// part of the way.
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
      const int32_t way = (i - steps) * steps;
      mean.add(way * blur.right_q10 / (4 * count),
               -way * blur.up_q10 / (4 * count), share(i));
    }
  }
  mean.emit();
}

}  // namespace

const Mixer kMotionBlurMixer = {nullptr, plan_blur, mix_blurred};

}  // namespace detail
}  // namespace inkcell
