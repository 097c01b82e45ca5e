// Splatting: each cell that is smaller than a pixel is sampled once.
//
//   uint32_t sums[64 * 16];
//   const Splat splat(sums);
//   style.set_effect(splat);
//
// Perry and Frisken, section 4.4, for fonts of fields. Cells up to the
// filter's radius wide are visited once. Each is one sample at its centre, or
// four at the centres of its quarters if it is wider than half the radius. A
// sample adds a weight, the filter at its distance times the cell's area, and
// weight times coverage to the sums of all pixels within the radius. Where
// cells are wider, the rest of a pixel's filter takes the coverage of plain
// drawing. A pixel shows the quotient of its two sums. Use it for patterns
// finer than pixels: there it is calmer, softer and cheaper than
// circle_samples.hpp.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/effect.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/span.hpp"

namespace inkcell {

namespace detail {
extern const Mixer kSplatMixer;
}  // namespace detail

/// The paper's radius, and the least and the greatest that there may be.
inline constexpr Q6_10 kSplatRadius = Q6_10::from_raw(1331);
inline constexpr Q6_10 kMinSplatRadius = Q6_10::from_raw(768);
inline constexpr Q6_10 kMaxSplatRadius = Q6_10::from_raw(1536);

/// The fewest sums that a splat draws with.
inline constexpr size_t kMinSplatSums = 64;

/// Font::check() refuses it with fonts of outlines, and with fewer than
/// kMinSplatSums sums.
struct Splat : Effect {
  /// With a sum for each pixel of the largest glyph in a strip, 2 px more on
  /// each side, cells are visited once a strip. With fewer a glyph is drawn in
  /// parts; the picture is the same. The radius is clamped to its range.
  constexpr explicit Splat(Span<uint32_t> all_sums,
                           Q6_10 radius = kSplatRadius) noexcept
      : Effect(detail::kSplatMixer),
        sums(all_sums),
        radius_q10(radius.raw < kMinSplatRadius.raw   ? kMinSplatRadius.raw
                   : radius.raw > kMaxSplatRadius.raw ? kMaxSplatRadius.raw
                                                      : radius.raw) {}

  /// A sum for each pixel. The caller's, in use while a glyph is drawn.
  Span<uint32_t> sums;
  int16_t radius_q10;  // of the filter, 2^(-3 (d / radius)^2) [px]
};

}  // namespace inkcell
