// Edges and strokes as eyes prefer them: contrast at small sizes.
//
//   constexpr EdgeContrast kContrast;
//   style.set_effect(kContrast);
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

#include "inkcell/effect.hpp"

namespace inkcell {

/// To coverage I in 0..1 both options add this share of I (1 - I). [1/256]
struct EdgeContrast : Effect {
  constexpr explicit EdgeContrast(uint8_t edge_share = 90,
                                  uint8_t thin_share = 96) noexcept
      : Effect(detail::kEdgeContrastMixer),
        edge(edge_share),
        thin(thin_share) {}

  uint8_t edge;
  uint8_t thin;
};

}  // namespace inkcell
