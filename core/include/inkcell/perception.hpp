// Edges and strokes as eyes prefer them: contrast at small sizes.
//
//   brush.set_painter(perception_painter(perception));
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

namespace detail {
void paint_perceptual(const GlyphField& field,
                      const Brush& brush,
                      const void* options,
                      const FinePoint& origin,
                      const Sink& sink);
}  // namespace detail

/// A pixel on an edge takes five gradients, others what they take in plain
/// drawing. Cells only; glyphs of outlines are drawn as without it. The options
/// must outlive the brush.
constexpr Painter perception_painter(const Perception& perception) noexcept {
  return {detail::paint_perceptual, nullptr, &perception, 1};
}
Painter perception_painter(const Perception&&) = delete;

}  // namespace inkcell
