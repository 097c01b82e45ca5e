// Shapes made of several grids while they are drawn: union, intersection,
// difference, smooth union (Perry and Frisken, section 3.3.3).
//
//   const GridPart parts[] = {{&stem, x0, y0},
//                             {&bowl, x1, y1},
//                             {&hole, x2, y2, Combine::subtract}};
//   draw_combined(parts, kFilterMotion, sink);  // for each strip
//
// The maximum of two distances is no distance where their edges are near each
// other: parts that overlap by less than a pixel would show a pale seam. There
// the angle between the edges decides: edges that face each other add up, edges
// at right angles cover like independent ones, and of parallel ones the farther
// counts. Parts thinner than a pixel have short gradients and add less.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/kinetic/distance_grid.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace kinetic {

/// What a part does to the shape that the parts before it make.
enum class Combine : uint8_t {
  unite,      // adds the part
  intersect,  // keeps what lies in the part
  subtract,   // takes the part away
  blend       // adds it, with a fillet where their edges meet
};

/// A grid at its place. The grid must outlive it.
struct GridPart {
  const DistanceGrid* grid = nullptr;
  Q16_16 x;  // of its upper left corner on the screen [px], within +-8191
  Q16_16 y;
  Combine how = Combine::unite;  // of no effect in the first part
  /// Of a blend: edges closer than this are joined. From 1 px to 3 sides of a
  /// sample of the grid: near the edge of the shape it knows no more.
  Q26_6 reach = Q26_6::from_int(3);
};

/// Distance and gradient of the shape at (x, y) on the screen, made a distance
/// again where coverage by `filter` depends on it: between its cutoffs. Far
/// from all parts, or without any, it is far outside. About 150 instructions
/// for each part (M4, -O2), and five more probes of each edge where two meet.
GridPoint combined_at(Span<const GridPart> parts,
                      Q16_16 x,
                      Q16_16 y,
                      const Filter& filter) noexcept;

/// Draws the shape.
void draw_combined(Span<const GridPart> parts,
                   const Filter& filter,
                   const Sink& sink) noexcept;

/// The pixels that the shape may touch with such a filter.
Rect combined_box(Span<const GridPart> parts, const Filter& filter) noexcept;

}  // namespace kinetic
}  // namespace inkcell
