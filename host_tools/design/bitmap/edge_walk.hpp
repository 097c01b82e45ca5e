// The edges in a bitmap, as dense points with sub-pixel accuracy.
#pragma once

#include <vector>

#include "bitmap/bitmap.hpp"
#include "fit/loop.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

/// The position of a master's glyph.
struct MasterPlace {
  double px_per_em = 1024;
  /// The glyph's origin from the upper left corner of the bitmap. [px]
  double origin_x = 0;
  double origin_y = 0;
  /// The fall of the baseline towards the right. [radians]
  double slope = 0;
};

/// The place given by the origin and the point on the baseline an em to its
/// right. [px] Throws Error if they are less than 16 px apart.
MasterPlace place_between(const Point& origin, const Point& em);

struct MasterOptions {
  MasterPlace place;
  /// The largest distance of curves from the edge's points; 0: the accuracy of
  /// the pixels, see pixel_tolerance(). [u]
  double tolerance_u = 0;
  /// Smaller specks and holes are dropped. [px^2]
  double least_area_px = 12;
  bool extremes = true;
};

/// Closed loops in u, filled on the left. In grey bitmaps the edge crosses a
/// pixel where a straight edge would leave this much ink. In bilevel bitmaps
/// the stairs are averaged along the edge.
std::vector<Loop> walk_edges(const Bitmap& bitmap,
                             const MasterOptions& options);

/// The accuracy of the pixels: 0.4 px for bilevel, 0.15 px for grey, at least
/// 0.1 u. [u]
double pixel_tolerance(const Bitmap& bitmap, const MasterPlace& place);

/// The master as lines and cubics: walks edges, finds corners, fits curves.
gen::Outline outline_of(const Bitmap& bitmap, const MasterOptions& options);

}  // namespace inkcell::design
