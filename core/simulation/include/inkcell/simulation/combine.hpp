// Combines several grids while they are drawn: union, intersection, difference,
// smooth union (Perry and Frisken, section 3.3.3).
//
//   const GridPart parts[] = {{&stem, x0, y0},
//                             {&bowl, x1, y1},
//                             {&hole, x2, y2, Combine::subtract}};
//   draw_combined(parts, kFilterMotion, sink);  // for each strip
//
// Where two edges are close, the maximum of two distances is no distance: parts
// that overlap by less than a pixel would show a pale seam. There coverage
// follows from the angle between the edges: opposite edges add up, edges at
// right angles cover independently, of parallel edges the outer one counts.
// Parts thinner than a pixel have short gradients and add less.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::simulation {

/// How a part changes the shape made by the parts before it.
enum class Combine : uint8_t {
  unite,      // adds the part
  intersect,  // keeps the intersection with the part
  subtract,   // removes the part
  blend       // adds it, with a fillet where their edges meet
};

/// A grid and its position. The grid must outlive it.
struct GridPart {
  const motion::DistanceGrid* grid = nullptr;
  Q16_16 x;  // upper left corner on the screen [px], within +-8191
  Q16_16 y;
  Combine how = Combine::unite;  // ignored in the first part
  /// For blend: edges closer than this are joined. 1 px to 3 sample sides of
  /// the grid, whose distances end at 4.
  Q26_6 reach = Q26_6::from_int(3);
};

/// Distance and gradient of the shape at (x, y) on the screen, corrected to a
/// true distance between the cutoffs of `filter`. Far from all parts, or
/// without parts: far outside. Cost: about 150 instructions a part (M4, -O2),
/// and five more probes of each edge where two meet.
motion::GridPoint combined_at(Span<const GridPart> parts,
                              Q16_16 x,
                              Q16_16 y,
                              const Filter& filter) noexcept;

/// Draws all pixels of it.
void draw_combined(Span<const GridPart> parts,
                   const Filter& filter,
                   const Sink& sink) noexcept;

/// The pixels that the shape may touch with `filter`.
Rect combined_box(Span<const GridPart> parts, const Filter& filter) noexcept;

}  // namespace inkcell::simulation
