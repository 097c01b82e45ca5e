// Whether a morph keeps its shape on the way.
#pragma once

#include <vector>

#include "morph/morph_pair.hpp"

namespace inkcell::gen {

using MorphPolygons = std::vector<std::vector<Point>>;

/// The contours at a progress of 0..1, each piece as `chords` lines. [u]
MorphPolygons morph_polygons(const MorphPair& pair,
                             double progress,
                             int chords);

/// Steps at which a morph is looked at, with both ends.
inline constexpr int kMorphSteps = 16;

/// Pieces that cross on the way.
struct MorphCrossing {
  int step;
  size_t contour[2];
  size_t piece[2];
};

struct MorphQuality {
  std::vector<MorphCrossing> crossings;  // of all steps between the ends
  /// How far the area leaves those of the ends, of the greater one.
  double area_error = 0;
  /// One side of a cut of both glyphs is a cut of both, the other is not: the
  /// device, which draws neither while a cut is closed, would tear the contour.
  bool is_torn = false;

  bool is_within(double most_area_error) const {
    return crossings.empty() && !is_torn && area_error <= most_area_error;
  }
};

MorphQuality quality_of(const MorphPair& pair);
/// Parts of it.
std::vector<MorphCrossing> crossings_of(const MorphPair& pair);
double area_error_of(const MorphPair& pair);

/// How much farther from the edge the ink reaches on the way than at the ends:
/// above 1, strokes run together.
double thickening_of(const MorphPair& pair);

/// The distance to the nearest edge; 0 outside, and where it is less than
/// `least`.
double depth_at(const MorphPolygons& polygons,
                const Point& at,
                double least = 0);

}  // namespace inkcell::gen
