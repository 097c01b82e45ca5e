// Supersampling: several samples a pixel, for type that moves, for patterns,
// and for the smallest text.
//
//   Supersampling supersampling = make_supersampling(filter);
//   style.set_effect(supersample_effect(supersampling));
//
// Outlines: the mean of five plain pictures, one in place and four moved to the
// corners of a square. Whatever the style's filter is, it draws the pictures.
// With AreaFilter ink varies by 0.3 % with the position at 12 px, with filter
// `text` by 2 % (7 % without supersampling). Costs 4 to 5 times the
// instructions of plain drawing, and two more bytes of RAM a pixel of a band,
// so that a glyph takes more bands.
//
// Cells: up to 13 distances on concentric circles around a pixel's centre
// (Perry and Frisken, section 4.3) where strokes, gaps and corners are too
// small for one. Costs about 20 times the instructions.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text_style.hpp"

namespace inkcell {

enum class SampleRule : uint8_t {
  /// Coverages are averaged: nothing pops when a glyph moves. Where the
  /// distance
  /// of cells is that of a straight edge, one sample is mapped to what 13 would
  /// give.
  even,
  /// The paper's: the size of the pixel's cell decides between 1, 5 and 13, and
  /// distances are averaged. Cells only: check_effect() refuses outlines.
  paper
};

/// Options of supersample_effect: 276 bytes, built once a style, shared.
struct Supersampling {
  SampleRule rule = SampleRule::even;
  int16_t radius_q10 = 0;  // of the filter [px]
  /// Weights of the centre and of each sample on a circle; all 13 are 2^16.
  uint16_t centre_q16 = 0;
  uint16_t inner_q16 = 0;
  uint16_t outer_q16 = 0;
  /// What 13 samples make of a straight edge.
  Filter edge;
  /// If not null, counts the samples of cells beyond one a pixel. Tasks that
  /// share it race.
  uint32_t* more_samples = nullptr;
};

/// Radii of the filter, 2^(-3 (d / radius)^2): for text with kFilterText; for
/// type that moves with kFilterMotion; and the paper's, which is softer and
/// keeps patterns calm that are finer than pixels.
inline constexpr Q6_10 kSharpRadius = Q6_10::from_raw(870);
inline constexpr Q6_10 kCalmRadius = Q6_10::from_raw(768);
inline constexpr Q6_10 kPaperRadius = Q6_10::from_raw(1331);

/// `filter` is that of the style; the radius is clamped to 0.25..1.5 px.
/// Divides and looks up some thousand times: once a style.
Supersampling make_supersampling(const Filter& filter,
                                 Q6_10 radius = kSharpRadius,
                                 SampleRule rule = SampleRule::even) noexcept;

namespace detail {
void paint_supersampled(const GlyphField& field,
                        const TextStyle& style,
                        const void* options,
                        const FinePoint& origin,
                        const Sink& sink);
extern const Mixer kSupersampleMixer;
}  // namespace detail

/// The options must outlive the style.
constexpr Effect supersample_effect(
    const Supersampling& supersampling) noexcept {
  return {detail::cell_effect(detail::paint_supersampled),
          supersampling.rule == SampleRule::paper ? nullptr
                                                  : &detail::kSupersampleMixer,
          &supersampling, 1};
}
Effect supersample_effect(const Supersampling&&) = delete;

}  // namespace inkcell
