// Draws a grid of distances with any filter, from any offset of its edges.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/kinetic/distance_grid.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace kinetic {

/// What is drawn of a grid.
struct GridLook {
  /// Distances below it are outside: above 0 there is less ink. [samples]
  Fixed<int32_t, 13> cutoff;
  /// Of fields whose slope is not 1 everywhere: how much distances are divided
  /// by it, 0 to 256. Edges are then as sharp as others, up to twice the slope.
  int32_t slope_q8 = 0;
};

/// Draws a grid with its upper left corner at pixel (x, y), within +-32767.
/// Distances are interpolated between samples. Far from edges a sample costs
/// about 20 instructions; near them a pixel about 30.
void draw_grid(const DistanceGrid& grid,
               const GridLook& look,
               int32_t x,
               int32_t y,
               const Filter& filter,
               const Sink& sink) noexcept;

/// An offset surface: a grid with its edges moved outwards, by up to 4 sides of
/// a sample less what the filter reaches. [px]
void draw_offset(const DistanceGrid& grid,
                 Q26_6 offset,
                 int32_t x,
                 int32_t y,
                 const Filter& filter,
                 const Sink& sink) noexcept;

}  // namespace kinetic
}  // namespace inkcell
