// Effects as a program writes them, by inkcell/mixer.hpp alone.
#pragma once

#include "inkcell/mixer.hpp"

namespace own_effects {

using namespace inkcell;

/// Dims glyphs but for every fourth diagonal.
struct Hatch : Effect {
  constexpr explicit Hatch(uint8_t dimmed_share) noexcept;

  uint8_t share;  // of 256, what is left between the diagonals
};

inline void plan_hatch(const Effect&, const Style&, BandPlan&) noexcept {}

inline void mix_hatch(const Effect& effect, GlyphBand& band) noexcept {
  const auto& hatch = static_cast<const Hatch&>(effect);
  const Rect& pixels = band.pixels();
  band.cover();
  for (int32_t y = pixels.y0; y < pixels.y1; ++y) {
    uint8_t* pixel = band.row(y);
    for (int32_t x = pixels.x0; x < pixels.x1; ++x, ++pixel) {
      if (((x + y) & 3) != 0) {
        *pixel = static_cast<uint8_t>(*pixel * hatch.share >> 8);
      }
    }
  }
  band.emit();
}

inline constexpr Mixer kHatchMixer = {nullptr, plan_hatch, mix_hatch};

constexpr Hatch::Hatch(uint8_t dimmed_share) noexcept
    : Effect(kHatchMixer), share(dimmed_share) {}

/// A ring around a glyph, between two distances from its edge.
struct Halo : Effect {
  constexpr Halo(Q6_10 from, Q6_10 to) noexcept;

  Q6_10 from_px;
  Q6_10 to_px;  // at most 4 px
};

inline void plan_halo(const Effect& effect,
                      const Style&,
                      BandPlan& plan) noexcept {
  const int32_t reach_q8 =
      (static_cast<const Halo&>(effect).to_px.raw >> 2) + 1;
  plan.outside_q8 = reach_q8;
  plan.ink_margin_q8 = reach_q8;
}

inline void mix_halo(const Effect& effect, GlyphBand& band) noexcept {
  const auto& halo = static_cast<const Halo&>(effect);
  const Rect& pixels = band.pixels();
  for (int32_t y = pixels.y0; y < pixels.y1; ++y) {
    DistanceRow distances = band.distances(y);
    uint8_t* pixel = band.row(y);
    for (int32_t x = pixels.x0; x < pixels.x1; ++x) {
      const int32_t outside_q10 = -distances.next_q10();
      *pixel++ = outside_q10 >= halo.from_px.raw && outside_q10 < halo.to_px.raw
                     ? 255
                     : 0;
    }
  }
  band.emit();
}

inline constexpr Mixer kHaloMixer = {kDistances, plan_halo, mix_halo};

constexpr Halo::Halo(Q6_10 from, Q6_10 to) noexcept
    : Effect(kHaloMixer), from_px(from), to_px(to) {}

/// The difference from the pixel to the right and below.
struct Relief : Effect {
  constexpr Relief() noexcept;
};

inline void plan_relief(const Effect&, const Style&, BandPlan& plan) noexcept {
  plan.margin_x = 1;
  plan.margin_y = 1;
}

// From the upper left to the lower right, so that a pixel is changed after it
// was read for the last time.
inline void mix_relief(const Effect&, GlyphBand& band) noexcept {
  const Rect& pixels = band.pixels();
  band.cover();
  for (int32_t y = pixels.y0; y < pixels.y1; ++y) {
    uint8_t* pixel = band.row(y);
    const uint8_t* below = band.row(y + 1) + 1;
    for (int32_t x = pixels.x0; x < pixels.x1; ++x, ++pixel, ++below) {
      *pixel =
          *pixel > *below ? static_cast<uint8_t>(*pixel - *below) : uint8_t{0};
    }
  }
  band.emit();
}

inline constexpr Mixer kReliefMixer = {kAreas, plan_relief, mix_relief};

constexpr Relief::Relief() noexcept : Effect(kReliefMixer) {}

inline constexpr Hatch kHatch(64);
inline constexpr Halo kHalo(Q6_10::from_raw(512), Q6_10::from_raw(2048));
inline constexpr Relief kRelief;

}  // namespace own_effects
