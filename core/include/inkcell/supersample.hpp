// Supersampling: several samples a pixel, for type that moves, for patterns,
// and for the smallest text.
//
//   const Supersampling supersampling = make_supersampling();
//   style.set_effect(supersample_effect(supersampling));
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

#include "inkcell/fixed.hpp"
#include "inkcell/style.hpp"

namespace inkcell {

/// Options of supersample_effect.
struct Supersampling {
  int16_t radius_q10 = 0;  // of the filter [px]
};

/// Radii of the filter, 2^(-3 (d / radius)^2): for text with kFilterText; for
/// type that moves with kFilterMotion; and the paper's, which is softer and
/// keeps patterns calm that are finer than pixels.
inline constexpr Q6_10 kSharpRadius = Q6_10::from_raw(870);
inline constexpr Q6_10 kCalmRadius = Q6_10::from_raw(768);
inline constexpr Q6_10 kPaperRadius = Q6_10::from_raw(1331);

/// The radius is clamped to 0.25..1.5 px.
constexpr Supersampling make_supersampling(
    Q6_10 radius = kSharpRadius) noexcept {
  constexpr int16_t kLeast = 256;
  constexpr int16_t kMost = 1536;
  return {radius.raw < kLeast  ? kLeast
          : radius.raw > kMost ? kMost
                               : radius.raw};
}

namespace detail {
extern const Mixer kSupersampleMixer;
}  // namespace detail

/// The options must outlive the style.
constexpr Effect supersample_effect(
    const Supersampling& supersampling) noexcept {
  return {&detail::kSupersampleMixer, &supersampling, 1};
}
Effect supersample_effect(const Supersampling&&) = delete;

}  // namespace inkcell
