// Edges and strokes as eyes prefer them: contrast at small sizes.
//
//   style.set_effect(edge_contrast_effect(edge_contrast));
//
// Left and lower edges become darker and right and upper ones lighter (Perry
// and Frisken, figure 11), most at half coverage, so that no stroke moves or
// changes its weight; and strokes so thin that the edges on both sides meet in
// a pixel become darker (figure 12).
//
// Both come from the coverage of a pixel and of those up to two pixels away,
// which the style's filter makes. Costs twice the instructions of plain
// drawing. Strokes up to 1 px count as thin, those of 1.75 px no longer.
#pragma once

#include <stdint.h>

#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"

namespace inkcell {

/// Options of edge_contrast_effect. Of coverage I in 0..1 both add this share
/// of I (1 - I). [1/256]
struct EdgeContrast {
  uint8_t edge = 90;
  uint8_t thin = 96;
};

namespace detail {
extern const Mixer kEdgeContrastMixer;
}  // namespace detail

/// The options must outlive the style.
constexpr Effect edge_contrast_effect(
    const EdgeContrast& edge_contrast) noexcept {
  return {&detail::kEdgeContrastMixer, &edge_contrast, 1};
}
Effect edge_contrast_effect(const EdgeContrast&&) = delete;

}  // namespace inkcell
