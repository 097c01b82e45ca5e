// The edges in a bitmap, as dense points finer than its pixels.
#pragma once

#include <vector>

#include "bitmap/bitmap.hpp"
#include "fit/loop.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

/// Where a master's glyph lies.
struct MasterPlace {
  double px_per_em = 1024;
  /// The glyph's origin from the upper left corner of the bitmap. [px]
  double origin_x = 0;
  double origin_y = 0;
  /// What the baseline falls towards the right. [radians]
  double slope = 0;
};

/// Where a master lies whose origin and the point of the baseline an em to its
/// right are known. [px] Throws Error if they are less than 16 px apart.
MasterPlace place_between(const Point& origin, const Point& em);

struct MasterOptions {
  MasterPlace place;
  /// Bound on the distance of curves from the edge's points; 0: what the
  /// pixels allow, see pixel_tolerance(). [u]
  double tolerance_u = 0;
  /// Specks and holes of less than this are dropped. [px^2]
  double least_area_px = 12;
  bool extremes = true;
};

/// Closed loops in u, filled on the left. Grey pixels: the edge crosses a pixel
/// where a straight edge of its direction would leave so much ink in it.
/// Pixels of ink or none: the stairs, averaged along the edge.
std::vector<Loop> walk_edges(const Bitmap& bitmap,
                             const MasterOptions& options);

/// What the pixels let one know: 0.4 px of ink or none, 0.15 px of greys, no
/// less than 0.1 u. [u]
double pixel_tolerance(const Bitmap& bitmap, const MasterPlace& place);

/// The master as lines and cubics: edges walked, corners found, curves fitted.
gen::Outline outline_of(const Bitmap& bitmap, const MasterOptions& options);

}  // namespace inkcell::design
