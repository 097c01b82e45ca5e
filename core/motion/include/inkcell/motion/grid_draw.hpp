// Draws a grid of distances with any filter and any offset of the edges.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::motion {

/// How a grid is drawn.
struct GridLook {
  /// Distances below it are outside: above 0 shapes get thinner. [samples]
  Fixed<int32_t, 13> cutoff;
  /// How far distances are divided by their slope, 0 (not at all) to 256. Keeps
  /// edges sharp where the slope is not 1, up to a slope of 2.
  int32_t slope_q8 = 0;
};

/// Draws a grid with its upper left corner at pixel (x, y), within +-32767.
/// Distances are interpolated between samples. Cost: about 20 instructions for
/// a sample far from edges, about 30 for a pixel near them.
void draw_grid(const DistanceGrid& grid,
               const GridLook& look,
               int32_t x,
               int32_t y,
               const Filter& filter,
               const Sink& sink) noexcept;

/// Draws an offset curve: edges move outwards by up to 4 sample sides less the
/// reach of the filter. [px]
void draw_offset(const DistanceGrid& grid,
                 Q26_6 offset,
                 int32_t x,
                 int32_t y,
                 const Filter& filter,
                 const Sink& sink) noexcept;

}  // namespace inkcell::motion
