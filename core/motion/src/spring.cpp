#include "inkcell/motion/spring.hpp"

#include "inkcell/motion/numbers.hpp"
#include "limits.hpp"

namespace inkcell::motion {

Q16_16 spring_at(const Spring& spring, int32_t time_ms) noexcept {
  constexpr int32_t kOne = 1 << 16;
  if (time_ms <= 0) {
    return {};
  }
  if (time_ms >= rest_ms(spring)) {
    return Q16_16::from_raw(kOne);
  }
  // Below 16 half-lives: less than 2^20. [Q16]
  const int64_t half = rest_ms(spring) / 16;
  const auto halves_q16 = static_cast<int32_t>(int64_t{time_ms} * kOne / half);
  // The rest of the swing fades out in the last half-life, so that the end is
  // no jump.
  const int32_t left_q16 =
      half_to_the(Q16_16::from_raw(halves_q16)).raw - (halves_q16 >> 20);
  constexpr int32_t kLn2Q16 = 45426;
  if (spring.period_ms <= 0) {
    const int64_t bend_q16 = kOne + ((int64_t{kLn2Q16} * halves_q16) >> 16);
    return Q16_16::from_raw(kOne -
                            static_cast<int32_t>(left_q16 * bend_q16 >> 16));
  }
  const int64_t turns_q16 = int64_t{time_ms} * kOne / spring.period_ms;
  const Angle angle = Angle::from_raw(static_cast<uint16_t>(turns_q16));
  // ln(2) / (2 pi) p / h, clamped to 256: hardly a spring any more. [Q16]
  constexpr int32_t kLn2OverTurnQ16 = 7230;
  const int64_t ratio_q16 = int64_t{spring.period_ms} * kLn2OverTurnQ16 / half;
  const int64_t slope_q16 = ratio_q16 < 256 * kOne ? ratio_q16 : 256 * kOne;
  const int64_t swing_q16 =
      int64_t{cosine(angle).raw} * 4 + (slope_q16 * sine(angle).raw >> 14);
  const int64_t value = kOne - (left_q16 * swing_q16 >> 16);
  return Q16_16::from_raw(clamp_i64(value, 0, 2 * kOne));
}

}  // namespace inkcell::motion
