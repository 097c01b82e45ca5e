// Splatting: each cell that is smaller than a pixel is sampled once.
//
//   uint32_t sums[64 * 16];
//   Splats splats;
//   INKCELL_TRY(make_splats({sums, 64 * 16}, kSplatRadius, splats));
//   style.set_effect(splat_effect(splats));
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

#include "inkcell/fixed.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/style.hpp"

namespace inkcell {

/// Options of splat_effect: make_splats makes them.
struct Splats {
  /// A sum for each pixel. The caller's, in use while a glyph is drawn.
  Span<uint32_t> sums;
  int16_t radius_q10 = 0;  // of the filter, 2^(-3 (d / radius)^2) [px]
  /// From squares of a distance in 1/128 px to 32 steps.
  uint16_t steps_q16 = 0;
};

/// The paper's radius, and the least and the greatest that there may be.
inline constexpr Q6_10 kSplatRadius = Q6_10::from_raw(1331);
inline constexpr Q6_10 kMinSplatRadius = Q6_10::from_raw(768);
inline constexpr Q6_10 kMaxSplatRadius = Q6_10::from_raw(1536);

/// The fewest sums that make_splats accepts.
inline constexpr size_t kMinSplatSums = 64;

/// With a sum for each pixel of the largest glyph in a strip, 2 px more on each
/// side, cells are visited once a strip. With fewer a glyph is drawn in parts;
/// the picture is the same.
///
/// buffer_small: fewer than kMinSplatSums. bad_argument: the radius is out of
/// range. `out` is then untouched.
Status make_splats(Span<uint32_t> sums, Q6_10 radius, Splats& out) noexcept;

namespace detail {
extern const Mixer kSplatMixer;
}  // namespace detail

/// check_effect() refuses it with fonts of outlines. The options must outlive
/// the style.
constexpr Effect splat_effect(const Splats& splats) noexcept {
  return {&detail::kSplatMixer, &splats, 2};
}
Effect splat_effect(const Splats&&) = delete;

}  // namespace inkcell
