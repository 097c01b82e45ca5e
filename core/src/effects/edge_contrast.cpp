// Contrast from the coverage of a pixel and those around it:
//
//            n              A side from the four beside it: to the right and up
//        k   a   m          coverage grows where a left or lower edge is.
//    j   b   c   d   o
//        l   e   p          Thin strokes from those two pixels away: both are
//            q              lighter, and b and d, or a and e, change alike.
//
#include "inkcell/edge_contrast.hpp"

#include "base/math.hpp"
#include "effects/mixed_rows.hpp"

namespace inkcell::detail {
namespace {

// Strokes up to kThin wide count in full, those of kWide not at all. [255 px]
constexpr int32_t kThin = 255;
constexpr int32_t kWide = 448;

// How far a pixel is in a thin stroke across a line of pixels `step` bytes
// apart; `across`: to the line's neighbour. [0 to 255]
int32_t thinness(const uint8_t* at, int32_t step, int32_t across) noexcept {
  const int32_t own = *at;
  const int32_t before = own - at[-2 * step];
  const int32_t after = own - at[2 * step];
  const int32_t width =
      at[-2 * step] + at[-step] + own + at[step] + at[2 * step];
  if (before <= 0 || after <= 0 || width >= kWide) {
    return 0;
  }
  // Gradients at both neighbours point at each other.
  const int32_t opposed =
      before * after - (at[-step - across] - at[-step + across]) *
                           (at[step - across] - at[step + across]);
  if (opposed <= 0) {
    return 0;
  }
  const int32_t thin = min(opposed * 255 / (own * own), 255);
  return width <= kThin ? thin : thin * (kWide - width) / (kWide - kThin);
}

// What a change by a share of I (1 - I) makes of a coverage. [1/65536]
int32_t changed(int32_t coverage, int32_t share_q16) noexcept {
  const int32_t room = coverage * (255 - coverage) / 255;
  return coverage + ((room * share_q16 + (1 << 15)) >> 16);
}

uint8_t contrasted(const uint8_t* at,
                   int32_t stride,
                   const EdgeContrast& contrast) noexcept {
  const int32_t grows = at[1] - at[-1] + at[-stride] - at[stride];
  const int32_t side = clamp(grows, -255, 255);
  const int32_t thin = max(thinness(at, 1, stride), thinness(at, stride, 1));
  const int32_t coverage = changed(*at, side * contrast.edge);
  return static_cast<uint8_t>(changed(coverage, thin * contrast.thin));
}

void mix_contrast(const Effect& effect, GlyphBand& band) noexcept {
  const auto& contrast = static_cast<const EdgeContrast&>(effect);
  const int32_t stride = band.stride();
  band.cover();
  mix_rows(band, [&](const uint8_t* at) noexcept {
    return *at == 0 || *at == 255 ? *at : contrasted(at, stride, contrast);
  });
}

}  // namespace

const Mixer kEdgeContrastMixer = {nullptr, plan_neighbours, mix_contrast};

}  // namespace inkcell::detail
