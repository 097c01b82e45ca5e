// Signed distances of anything that can be drawn, on a grid in the caller's
// RAM.
//
//   int8_t samples[40 * 48];
//   DistanceGrid grid(samples, 40, 48, 1);  // for 80 x 96 px
//   INKCELL_TRY(grid.paint(font, glyph, size, origin));
//
// A filter with a ramp of 8 px turns distance into coverage without loss, so
// the renderer fills the grid, from fonts of every coding. Glyphs are painted
// 2^scale_log2 times smaller than they will be shown.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/workspace.hpp"

namespace inkcell::motion {

/// Coverage as distance: 128 at the edge, 32 more for each px inside.
extern const Filter kFilterDistance;

/// A view of samples in the caller's memory. A sample holds the signed distance
/// at the centre of a square of 2^scale_log2 px, positive inside, in units of
/// 1/32 of the square's side, clamped to -128..127 (4 sides). Copies share the
/// samples.
class DistanceGrid {
 public:
  static constexpr int8_t kOutside = -128;
  static constexpr int32_t kMaxSide = 1024;  // [samples]
  static constexpr int32_t kMaxScaleLog2 = 3;

  constexpr DistanceGrid() noexcept = default;
  /// A grid of width x height samples at `samples`. The grid is empty if a side
  /// is not in 1..kMaxSide or there are too few samples.
  DistanceGrid(Span<int8_t> samples,
               int32_t width,
               int32_t height,
               int32_t scale_log2) noexcept;

  /// The samples that a width or height needs. [px -> samples]
  static constexpr int32_t samples_of(int32_t px, int32_t scale_log2) noexcept {
    return (px + (1 << scale_log2) - 1) >> scale_log2;
  }

  int32_t width() const noexcept { return width_; }    // [samples]
  int32_t height() const noexcept { return height_; }  // [samples]
  int32_t scale_log2() const noexcept { return scale_log2_; }
  int32_t width_px() const noexcept { return width_ << scale_log2_; }
  int32_t height_px() const noexcept { return height_ << scale_log2_; }

  /// Sample (x, y), y down; kOutside beyond the grid.
  int8_t at(int32_t x, int32_t y) const noexcept {
    return x >= 0 && x < width_ && y >= 0 && y < height_
               ? samples_[y * width_ + x]
               : kOutside;
  }
  /// The samples of row y, 0 <= y < height().
  const int8_t* row(int32_t y) const noexcept { return samples_ + y * width_; }
  int8_t* row(int32_t y) noexcept { return samples_ + y * width_; }

  /// The coverage of a sample's square: it stands for the middle of its step.
  /// [1/64]
  static constexpr int32_t coverage_of(int8_t sample) noexcept {
    return detail::clamp(2 * sample + 33, 0, 64);
  }

  /// The greatest sample, at least 0: the distance of the innermost point from
  /// the edge. [1/32 of a side]
  int32_t depth() const noexcept;

  /// The area of the ink, by coverage_of(). [1/64 of a square]
  int32_t area() const noexcept;

  /// The smallest box around all samples that are not kOutside. [samples] Empty
  /// if there are none.
  Rect known_box() const noexcept;

  /// Sets all samples to kOutside.
  void clear() noexcept;

  /// A sink for anything drawn with kFilterDistance, one pixel a sample: what
  /// is drawn is united with the grid. The grid must outlive the sink.
  Sink sink() noexcept;

  /// Unites the grid with a glyph of `size` px to the em. `origin` is in px
  /// from the grid's upper left corner. bad_argument: size / 2^scale_log2 is
  /// not in kMinSize..kMaxSize. beyond_band: a font of a field whose distances
  /// end before 4 px at that size; outlines have no such limit.
  Status paint(const Font& font,
               uint16_t glyph,
               Q26_6 size,
               Point origin,
               Workspace workspace = {}) noexcept;

 private:
  int8_t* samples_ = nullptr;
  int32_t width_ = 0;
  int32_t height_ = 0;
  int32_t scale_log2_ = 0;
};

/// Distance and gradient at a place.
struct GridPoint {
  int32_t distance_q10 = 0;  // [px]
  int32_t x_slope_q13 = 0;   // about 1 near an edge; y down
  int32_t y_slope_q13 = 0;
};

/// The bilinear distance at a place, in px from the grid's upper left corner.
/// About 60 instructions. Outside of the grid: far outside, gradient 0.
GridPoint probe(const DistanceGrid& grid, Q16_16 x, Q16_16 y) noexcept;

}  // namespace inkcell::motion
