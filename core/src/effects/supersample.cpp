// Supersampling: five pictures, one in place and four moved to the
// corners of a square.
//
//   o     o     Where they lie and what they count give the mean the variance
//      c        of 13 samples of the same radius, 0.12 of its square along each
//   o     o     axis.
#include "inkcell/supersample.hpp"

#include "base/math.hpp"
#include "effects/mean.hpp"

namespace inkcell::detail {
namespace {

struct Corners {
  int32_t away_q8;  // along both axes [px]
  uint32_t share;   // of one of them, of 256
};

// Shares of 38 or so, as long as corners are at most half a pixel away: farther
// pictures would leave a gap at the centre.
Corners corners_of(const Effect& effect) noexcept {
  const int32_t radius_q10 = static_cast<const Supersample&>(effect).radius_q10;
  const int32_t away_q8 = min(radius_q10 * 458 >> 12, 128);
  const int32_t away_q10 = max(4 * away_q8, 1);
  const int32_t all_q8 = 31 * radius_q10 * radius_q10 / (away_q10 * away_q10);
  return {away_q8, static_cast<uint32_t>(min(all_q8 >> 2, 64))};
}

void plan_supersampling(const Effect& effect,
                        const Style&,
                        BandPlan& plan) noexcept {
  plan.sample_bytes = Mean::kSampleBytes;
  plan.moved_x_q8 = static_cast<int16_t>(corners_of(effect).away_q8);
  plan.moved_y_q8 = plan.moved_x_q8;
}

void mix_supersampled(const Effect& effect, GlyphBand& band) noexcept {
  const Corners corners = corners_of(effect);
  const int32_t away = corners.away_q8;
  Mean mean(band);
  mean.add(256 - 4 * corners.share);
  mean.add(away, away, corners.share);
  mean.add(-away, away, corners.share);
  mean.add(-away, -away, corners.share);
  mean.add(away, -away, corners.share);
  mean.emit();
}

}  // namespace

const Mixer kSupersampleMixer = {nullptr, plan_supersampling, mix_supersampled};

}  // namespace inkcell::detail
