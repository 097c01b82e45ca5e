// What lies between two grids of distances.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/kinetic/distance_grid.hpp"

namespace inkcell {
namespace kinetic {

/// A shape that becomes another, by their distances a and b:
///
///     max((1 - part) a + part b, a - part depth_a, b - (1 - part) depth_b)
///
/// The first moves edges from one to the other; alone it would break what only
/// one of them has. The others let that grow thin, and become strokes.
struct GridBlend {
  int32_t part_q8 = 0;  // 0 to 256
  /// DistanceGrid::depth() and what the filter reaches outwards: a stroke of no
  /// width still shows as far. 0 to 255. [1/32 of a sample's side]
  int32_t depth_a = 0;
  int32_t depth_b = 0;
  /// DistanceGrid::area(). [1/64 of a sample]
  int32_t area_a = 0;
  int32_t area_b = 0;
};

/// How many samples have which distance: 256 bytes, whose content has no
/// meaning between calls.
struct GridHistogram {
  static constexpr int32_t kBins = 128;
  uint16_t bins[kBins];
};

/// Fills `out`, which may be `a` or `b`, with a blend of grids as large and of
/// the same scale. Returns the cutoff with which its area goes evenly from that
/// of `a` to that of `b` as the part goes from 0 to 256: 0 at both ends.
/// [samples] About 30 instructions a sample.
///
/// Grids that do not fit each other: `out` is untouched, and the result is 0.
Fixed<int32_t, 13> blend(const DistanceGrid& a,
                         const DistanceGrid& b,
                         const GridBlend& how,
                         DistanceGrid& out,
                         GridHistogram& scratch) noexcept;

/// The cutoff with which a grid has an area: it holds that of a shape that
/// flows. [1/64 of a sample -> samples] About 15 instructions a sample.
Fixed<int32_t, 13> cutoff_for(const DistanceGrid& grid,
                              int32_t area,
                              GridHistogram& scratch) noexcept;

}  // namespace kinetic
}  // namespace inkcell
