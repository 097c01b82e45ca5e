// Supersampling: several samples a pixel, for type that moves, for patterns,
// and for the smallest text.
//
//   constexpr Supersample kSupersample;
//   style.set_effect(kSupersample);
//
// The mean of five plain pictures, one in place and four moved to the
// corners of a square. Whatever the style's filter is, it draws the pictures.
// With kFilterArea ink varies by 0.3 % with the position at 12 px, with filter
// `text` by 2 % (7 % without supersampling). Costs 4 to 5 times the
// instructions of plain drawing, and two more bytes of RAM a pixel of a band,
// so that a glyph takes more bands.
//
// Fields have up to 13 samples where one is not accurate enough as well:
// inkcell/field/circle_samples.hpp.
#pragma once

#include <stdint.h>

#include "inkcell/effect.hpp"
#include "inkcell/fixed.hpp"

namespace inkcell {

/// Radii of the filter, 2^(-3 (d / radius)^2): for text with kFilterText; for
/// type that moves with kFilterMotion; and the paper's, which is softer and
/// keeps patterns calm that are finer than pixels.
inline constexpr Q6_10 kSharpRadius = Q6_10::from_raw(870);
inline constexpr Q6_10 kCalmRadius = Q6_10::from_raw(768);
inline constexpr Q6_10 kPaperRadius = Q6_10::from_raw(1331);

/// The least and the greatest radius.
inline constexpr Q6_10 kMinRadius = Q6_10::from_raw(256);
inline constexpr Q6_10 kMaxRadius = Q6_10::from_raw(1536);

/// The mean of a circle of samples about a pixel, instead of one.
struct Supersample : Effect {
  /// The radius is clamped to kMinRadius..kMaxRadius.
  constexpr explicit Supersample(Q6_10 radius = kSharpRadius) noexcept
      : Effect(detail::kSupersampleMixer),
        radius_q10(static_cast<int16_t>(
            detail::clamp(radius.raw, kMinRadius.raw, kMaxRadius.raw))) {}

  int16_t radius_q10;  // [px]
};

}  // namespace inkcell
