// Motion blur: pictures along the path of the glyph, half a pixel apart or
// less, so that the squares of pixels leave no gaps between them.
#include "inkcell/motion_blur.hpp"

#include "base/math.hpp"
#include "effects/mean.hpp"

namespace inkcell::detail {
namespace {

void plan_blur(const Effect& effect, const Style&, BandPlan& plan) noexcept {
  const auto& blur = static_cast<const MotionBlur&>(effect);
  const auto half_q8 = [&blur](int32_t step_q10) noexcept {
    return static_cast<int16_t>((abs(step_q10) * blur.steps >> 3) + 1);
  };
  plan.sample_bytes = Mean::kSampleBytes;
  plan.moved_x_q8 = half_q8(blur.right_q10);
  plan.moved_y_q8 = half_q8(blur.up_q10);
}

// Two pictures a step and one in the middle, each in the middle of an equal
// part of the path.
void mix_blurred(const Effect& effect, GlyphBand& band) noexcept {
  const auto& blur = static_cast<const MotionBlur&>(effect);
  const int32_t steps = blur.steps;
  const int32_t count = 2 * steps + 1;
  const auto share = [count](int32_t i) noexcept {
    return static_cast<uint32_t>((i + 1) * 256 / count - i * 256 / count);
  };
  Mean mean(band);
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

}  // namespace inkcell::detail
