// Up to 13 samples a pixel of a field, where one is not accurate enough.
//
//   constexpr CircleSamples kSamples(kFilterText);
//   style.set_effect(kSamples);
//
// Distances on concentric circles around a pixel's centre (Perry and Frisken,
// section 4.3) are sampled where strokes, gaps and corners are too small for
// one. For fonts of fields; supersample.hpp serves all fonts.
#pragma once

#include <stdint.h>

#include "inkcell/effect.hpp"
#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/supersample.hpp"

namespace inkcell {

namespace detail {
extern const Mixer kCircleSamplesMixer;

// A circle's radius by thirds of the filter's, and an axis of a point that lies
// on it diagonally. [px, Q10]
constexpr int32_t circle_q10(int32_t radius_q10, int32_t thirds) noexcept {
  return radius_q10 * thirds / 3;
}
constexpr int32_t diagonal_q10(int32_t length_q10) noexcept {
  constexpr int32_t kHalfRootQ15 = 23170;
  return (length_q10 * kHalfRootQ15) >> 15;
}
}  // namespace detail

/// Which samples are taken, and how much each counts.
enum class SampleRule : uint8_t {
  /// Where the distance is that of a straight edge, one sample is mapped to
  /// what 13 would give; everywhere else coverages are averaged, and the two
  /// blend: nothing pops when a glyph moves.
  even,
  /// The paper's: the size of the pixel's cell decides between 1, 5 and 13, and
  /// distances are averaged.
  paper
};

/// 280 bytes. Font::check() refuses it with fonts of outlines, and with styles
/// that stretch edges differently.
struct CircleSamples : Effect {
  /// `filter` is that of the style; the radius is clamped as in
  /// supersample.hpp. Divides and looks up some thousand times, unless it is a
  /// constant.
  constexpr explicit CircleSamples(
      const Filter& filter,
      Q6_10 radius = kSharpRadius,
      SampleRule sample_rule = SampleRule::even) noexcept
      : Effect(detail::kCircleSamplesMixer),
        rule(sample_rule),
        radius_q10(Supersample(radius).radius_q10),
        edge(edge_of(filter, radius_q10)) {}

  /// Weights of each sample on a circle and of the centre; all 13 are 2^16: 1,
  /// 2^(-1/3) and 2^(-4/3), over 1 + 4 inner + 8 outer.
  static constexpr int32_t kInnerQ16 = 7077;
  static constexpr int32_t kOuterQ16 = 3539;
  static constexpr int32_t kCentreQ16 =
      (1 << 16) - 4 * kInnerQ16 - 8 * kOuterQ16;

  SampleRule rule;
  int16_t radius_q10;  // of the filter [px]
  /// What 13 samples make of a straight edge.
  Filter edge;
  /// If not null, counts the samples beyond one a pixel. Tasks that share it
  /// race.
  uint32_t* more_samples = nullptr;

 private:
  static constexpr Filter edge_of(const Filter& filter,
                                  int32_t radius_q10) noexcept;
};

// The mean of an edge along the axes and one along the diagonals: what lies on
// the axes of one lies on the diagonals of the other.
constexpr Filter CircleSamples::edge_of(const Filter& filter,
                                        int32_t radius_q10) noexcept {
  const int32_t outer = detail::circle_q10(radius_q10, 2);
  const int32_t inner = detail::circle_q10(radius_q10, 1);
  const int32_t low = filter.outside_q10 - outer;
  const int32_t high = filter.inside_q10 + outer;
  Filter edge;
  edge.outside_q10 = static_cast<int16_t>(low);
  edge.inside_q10 = static_cast<int16_t>(high);
  edge.scale = static_cast<uint16_t>((Filter::kEntries << 14) / (high - low));
  for (int32_t i = 0; i < Filter::kEntries; ++i) {
    const int32_t middle = low + ((2 * i + 1) * (high - low)) / 512;
    const auto both = [&filter, middle](int32_t offset) noexcept {
      return filter.coverage(middle - offset) +
             filter.coverage(middle + offset);
    };
    const int32_t centre = filter.coverage(middle);
    // Twice what one of the two edges has.
    const int32_t on_outer = 4 * centre + 2 * both(outer);
    const int32_t off_outer = 4 * both(detail::diagonal_q10(outer));
    const int32_t on_inner = 2 * centre + both(inner);
    const int32_t off_inner = 2 * both(detail::diagonal_q10(inner));
    const int32_t sum_q17 = 2 * centre * kCentreQ16 +
                            (on_inner + off_inner) * kInnerQ16 +
                            (on_outer + off_outer) * kOuterQ16;
    edge.table[i] = static_cast<uint8_t>((sum_q17 + (1 << 16)) >> 17);
  }
  return edge;
}

}  // namespace inkcell
