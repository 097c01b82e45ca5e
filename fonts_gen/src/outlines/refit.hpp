// The fewest points that draw a glyph within a tolerance.
#pragma once

#include <vector>

#include "outlines/refit_memo.hpp"
#include "shape/outline.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {

/// Options of minimal_outline().
struct RefitOptions {
  int units_per_em = 1024;
  /// A grid unit is 2^grid_shift font units, grid_shift = -4..3.
  int grid_shift = 0;
  /// The largest distance between result and source, in both directions. [u] If
  /// the grid is too coarse for it, the nearest points of the grid are used.
  double tolerance_u = 0.5;
  /// Within kCareRadius_u of these places a quarter of the tolerance holds and
  /// every joint is an explicit corner.
  std::vector<Point> careful_u;
  /// Within kCareRadius_u of these places the source's own joints are kept,
  /// its curves are cut in halves, and every joint is an explicit corner.
  std::vector<Point> exact_u;
};

/// Reach of a place in RefitOptions. [u]
inline constexpr double kCareRadius_u = 24;

/// Refits the contours of `united`, which neither cross nor overlap (see
/// unite()), with the lines and quadratics that take the fewest bits. Corners
/// and extremes stay in place. The same result on every machine. Empty for an
/// outline that fills nothing.
///
/// The result is compared with `shape`, the area of `united`, in both
/// directions. Places that deviate or overlap are refitted with more care.
/// Details narrower than the grid may still deviate. 95 glyphs take 1 to 2 s on
/// one core.
///
/// `memo` caches what several calls for one glyph share; the result does not
/// depend on it. Throws GeometryError.
MinimalOutline minimal_outline(const Outline& united,
                               const Shape& shape,
                               const RefitOptions& options,
                               RefitMemo& memo);

}  // namespace inkcell::gen
