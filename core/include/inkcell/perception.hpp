// Edges and strokes as eyes prefer them: contrast at small sizes.
//
//   brush.set_painter(paint_perceptual, &perception, kPerceptionReach);
//
// Left and lower edges become darker and right and upper ones lighter (Perry
// and Frisken, figure 11), by as much as a pixel is between empty and full, so
// that no stroke moves or changes its weight; and strokes so thin that the
// edges on both sides meet in a pixel become darker (figure 12).
#pragma once

#include <stdint.h>

#include "inkcell/brush.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {

/// Options of paint_perceptual. Of coverage I in 0..1 both add this share of
/// I (1 - I). [1/256]
struct Perception {
  uint8_t edge = 90;
  uint8_t thin = 96;
};

/// What Brush::set_painter wants as `reach_px`.
inline constexpr uint8_t kPerceptionReach = 1;

/// A Painter; `options` is a Perception. A pixel on an edge takes five
/// gradients, others what they take in plain drawing.
void paint_perceptual(const GlyphField& field,
                      const Brush& brush,
                      const void* options,
                      const FinePoint& origin,
                      const RowMap* rows,
                      const Sink& sink);

}  // namespace inkcell
