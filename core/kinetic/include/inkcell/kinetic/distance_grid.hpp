// Signed distances of anything that was drawn, on a grid in the caller's RAM.
//
//   int8_t samples[40 * 48];
//   DistanceGrid grid(samples, 40, 48, 1);  // for 80 x 96 px
//   INKCELL_TRY(grid.paint(font, glyph, size, origin));
//
// A filter whose ramp is 8 px wide turns distance into coverage without loss:
// so the renderer itself fills the grid, from fonts of every coding. Glyphs are
// painted 2^scale_log2 times smaller than they will be shown.
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

namespace inkcell {
namespace kinetic {

/// Coverage that is distance: 128 at the edge, 32 for each px inside.
extern const Filter kFilterDistance;

/// A view of samples in the caller's memory. Each stands for the centre of a
/// square of 2^scale_log2 px and holds the signed distance there in units of
/// 1/32 of the square's side, positive inside, clamped to -128..127: 4 sides.
/// Copies share the samples.
class DistanceGrid {
 public:
  static constexpr int8_t kOutside = -128;
  static constexpr int32_t kMaxSide = 1024;  // [samples]
  static constexpr int32_t kMaxScaleLog2 = 3;

  constexpr DistanceGrid() noexcept = default;
  /// Of width x height samples, which begin anywhere in `samples`. The grid is
  /// empty where a side is not in 1..kMaxSide, or the samples are too few.
  DistanceGrid(Span<int8_t> samples,
               int32_t width,
               int32_t height,
               int32_t scale_log2) noexcept;

  /// How many samples a width or height needs. [px -> samples]
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
  /// The samples of row y, which must be in the grid.
  const int8_t* row(int32_t y) const noexcept { return samples_ + y * width_; }
  int8_t* row(int32_t y) noexcept { return samples_ + y * width_; }

  /// The greatest sample, at least 0: how far the innermost point is from the
  /// edge. [1/32 of a side]
  int32_t depth() const noexcept;

  /// What is inside, where a sample covers its square by a ramp of one side.
  /// [1/64 of a square]
  int32_t area() const noexcept;

  /// The smallest box around all samples that are not kOutside. [samples] Empty
  /// if there are none.
  Rect known_box() const noexcept;

  /// Nothing is inside.
  void clear() noexcept;

  /// A sink for whatever draws with kFilterDistance, with a sample for a pixel.
  /// What is drawn is united with what is there. The grid must outlive it.
  Sink sink() noexcept;

  /// Unites the grid with a glyph of `size` px to the em, whose origin is at
  /// `origin`, in px from the grid's upper left corner. bad_argument: the size
  /// over 2^scale_log2 is not one of kMinSize to kMaxSize. beyond_band: it is
  /// a font of cells that know less than 4 px at that size; outlines know all.
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

/// Distance and gradient at one place.
struct GridPoint {
  int32_t distance_q10 = 0;  // [px]
  int32_t x_slope_q13 = 0;   // about unit length near an edge; y down
  int32_t y_slope_q13 = 0;
};

/// The field at a place in px from the grid's upper left corner, between four
/// samples. About 60 instructions. Beyond the grid it is far outside and flat.
GridPoint probe(const DistanceGrid& grid, Q16_16 x, Q16_16 y) noexcept;

}  // namespace kinetic
}  // namespace inkcell
