// Up to 13 samples a pixel of a field, where one is not accurate enough.
//
//   CircleSamples samples = make_circle_samples(filter);
//   style.set_effect(circle_samples_effect(samples));
//
// Distances on concentric circles around a pixel's centre (Perry and Frisken,
// section 4.3) are sampled where strokes, gaps and corners are too small for
// one. For fonts of fields; supersample.hpp serves all fonts.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/style.hpp"
#include "inkcell/supersample.hpp"

namespace inkcell {

enum class SampleRule : uint8_t {
  /// Where the distance is that of a straight edge, one sample is mapped to
  /// what 13 would give; everywhere else coverages are averaged, and the two
  /// blend: nothing pops when a glyph moves.
  even,
  /// The paper's: the size of the pixel's cell decides between 1, 5 and 13, and
  /// distances are averaged.
  paper
};

/// Options of circle_samples_effect: 284 bytes, built once a style, shared.
struct CircleSamples {
  SampleRule rule = SampleRule::even;
  int16_t radius_q10 = 0;  // of the filter [px]
  /// Weights of the centre and of each sample on a circle; all 13 are 2^16.
  uint16_t centre_q16 = 0;
  uint16_t inner_q16 = 0;
  uint16_t outer_q16 = 0;
  /// What 13 samples make of a straight edge.
  Filter edge;
  /// If not null, counts the samples beyond one a pixel. Tasks that share it
  /// race.
  uint32_t* more_samples = nullptr;
};

/// `filter` is that of the style; the radius, as supersample.hpp has them, is
/// clamped to 0.25..1.5 px.
/// Divides and looks up some thousand times: once a style.
CircleSamples make_circle_samples(const Filter& filter,
                                  Q6_10 radius = kSharpRadius,
                                  SampleRule rule = SampleRule::even) noexcept;

namespace detail {
extern const Mixer kCircleSamplesMixer;
}  // namespace detail

/// check_effect() refuses it with fonts of outlines. The options must outlive
/// the style.
constexpr Effect circle_samples_effect(const CircleSamples& samples) noexcept {
  return {&detail::kCircleSamplesMixer, &samples, 1};
}
Effect circle_samples_effect(const CircleSamples&&) = delete;

}  // namespace inkcell
