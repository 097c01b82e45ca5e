// Blends two grids of distances.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/motion/distance_grid.hpp"

namespace inkcell::motion {

/// A shape between two others, from their distances a and b:
///
///     max((1 - part) a + part b, a - part depth_a, b - (1 - part) depth_b)
///
/// The first term moves edges from one shape to the other; alone it would break
/// strokes that only one of them has. The others make such strokes grow or
/// shrink evenly.
struct GridBlend {
  int32_t part_q8 = 0;  // 0 to 256
  /// DistanceGrid::depth() plus the reach of the filter outwards, as a stroke
  /// of width 0 still shows that far. 0 to 255. [1/32 of a sample's side]
  int32_t depth_a = 0;
  int32_t depth_b = 0;
  /// DistanceGrid::area(). [1/64 of a sample]
  int32_t area_a = 0;
  int32_t area_b = 0;
};

/// A histogram of the samples: 256 bytes of scratch memory, without meaning
/// between calls.
struct GridHistogram {
  static constexpr int32_t kBins = 128;
  uint16_t bins[kBins];
};

/// Fills `out` with a blend of `a` and `b`; all have the same size and scale,
/// and `out` may be `a` or `b`. Returns the cutoff [samples] that makes the
/// area change evenly with the part: 0 at both ends. About 30 instructions a
/// sample.
///
/// If the sizes differ, `out` is untouched and the result is 0.
Fixed<int32_t, 13> blend(const DistanceGrid& a,
                         const DistanceGrid& b,
                         const GridBlend& how,
                         DistanceGrid& out,
                         GridHistogram& scratch) noexcept;

/// The cutoff that gives a grid the area `area`: keeps the area of a shape that
/// flows. [1/64 of a sample -> samples] About 15 instructions a sample.
Fixed<int32_t, 13> cutoff_for(const DistanceGrid& grid,
                              int32_t area,
                              GridHistogram& scratch) noexcept;

}  // namespace inkcell::motion
