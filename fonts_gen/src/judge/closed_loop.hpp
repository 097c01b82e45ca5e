// The closed loop: what the device draws, at every size, against the truth.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "inkcell/field/glyph_field.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "judge/true_pictures.hpp"
#include "shape/distance_map.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {

/// Sub-pixel positions that the loop knows.
inline constexpr int kLoopPhases = 8;

/// Other positions may look a little worse: outlines are refitted until so much
/// of the tolerance is left. [1/255]
inline constexpr double kPositionReserve = 0.75;

struct LoopOptions {
  /// Sizes. [px/em] Whole numbers, kMinSize..kMaxSize, min <= max.
  int min_px = 8;
  int max_px = 64;
  /// What pixels are compared with: filter `text`, or exact area.
  Measure measure = Measure::distance;
  /// Sub-pixel positions at each size, 1..kLoopPhases. Above 128 px there are
  /// fewer: one phase's pixels lie denser there than all of them below.
  int phases = kLoopPhases;
  /// A pixel farther from the truth is a miss. [1/255]
  double tolerance = 16;
  /// Misses to hand back, the worst ones first.
  size_t max_misses = 256;
};

/// A pixel that differs from the truth.
struct LoopMiss {
  double x_u = 0;  // its centre in the glyph
  double y_u = 0;
  int px = 0;        // the size at which it was drawn
  double error = 0;  // [1/255]
};

/// Errors at one size, all phases together. [1/255]
struct SizeError {
  int px = 0;
  double worst = 0;
  /// Over the pixels whose centres lie in the ink box or up to 1.5 px around,
  /// with the truth of TruePictures.
  double mean = 0;
};

struct LoopResult {
  std::vector<SizeError> sizes;  // ascending
  std::vector<LoopMiss> misses;  // worst first
  size_t miss_count = 0;         // all of them, not only those handed back
  double worst = 0;              // of all sizes
  LoopMiss worst_pixel;          // a pixel of that error
  double worst_mean = 0;         // the largest mean of a size
};

/// Errors of a glyph.
struct GlyphErrors {
  /// With the default filter, which is area. Of outlines the worst holds at any
  /// position: see bound_areas(). Of fields it is the distance.
  LoopResult promised;
  /// With the filter `text`, at the positions that the loop tries.
  LoopResult distance;
};

/// A glyph as the device draws it, with its origin at `origin`.
struct LoopGlyph {
  /// The pixels that it may touch.
  std::function<Rect(const Style& style, inkcell::Point origin)> box;
  std::function<void(
      const Style& style, inkcell::Point origin, const Sink& sink)>
      draw;
};

/// The sizes that a loop draws: every whole one up to 128 px/em, then steps of
/// 1/64, and `max_px`. Ascending.
std::vector<int> loop_sizes(int min_px, int max_px);

/// What a glyph should be: nearly, for every pixel, and exactly, for those that
/// matter.
struct LoopTruth {
  LoopTruth(const Shape& shape, Measure measure, double reach_u)
      : pictures(shape, measure), map(shape, reach_u) {}

  TruePictures pictures;
  DistanceMap map;
};

/// Draws a glyph with the device's own renderer, filter `text` or area, and
/// compares each pixel with the coverage that the exact distance to the shape
/// gives, not rounded, or with the area of TruePictures. The exact distance is
/// only found where a near one shows that the pixel may matter. A pixel that
/// the device draws outside of the area of the mean counts for the worst one.
///
/// What is known of the shape is kept, so that asking again for another coding
/// of the same glyph costs little more than the drawing. Not for several
/// threads at once; refers to the shape, which must outlive it.
class ClosedLoop {
 public:
  ClosedLoop(const Shape& shape, const LoopOptions& options);

  /// The result depends on the shape, the options and `glyph` only. Where no
  /// pixel of an outline misses by distance, those that are near to the
  /// tolerance are followed to other positions, in steps of 1/64 px, and to the
  /// next sizes, as long as they get worse. Fields of cells have no such
  /// places.
  LoopResult draw_and_compare(const LoopGlyph& glyph);
  LoopResult draw_and_compare(const GlyphField& field);

 private:
  LoopResult draw_sizes(const LoopGlyph& glyph, bool follows);

  const Shape& shape_;
  LoopOptions options_;
  std::optional<LoopTruth> truth_;  // none if the shape is empty
};

}  // namespace inkcell::gen
