// Distances and gradients at points that lie close to each other: any number of
// them to a pixel, upright or turned. The leaf of the last point is kept.
#pragma once

#include <stdint.h>

#include "cells/leaf_reader.hpp"
#include "distance/csg.hpp"
#include "distance/samples.hpp"
#include "distance/stretching.hpp"
#include "place/cell_map.hpp"

namespace inkcell {
namespace detail {

// A place on the screen relative to another. [px, Q10]
struct ScreenOffset {
  int32_t right_q10;
  int32_t up_q10;
};

inline GlyphPoint moved(const GlyphPoint& at, const GlyphPoint& by) noexcept {
  return {at.x_q16 + by.x_q16, at.y_q16 + by.y_q16, at.x_q20 + by.x_q20,
          at.y_q20 + by.y_q20};
}
inline GlyphPoint moved_back(const GlyphPoint& at,
                             const GlyphPoint& by) noexcept {
  return {at.x_q16 - by.x_q16, at.y_q16 - by.y_q16, at.x_q20 - by.x_q20,
          at.y_q20 - by.y_q20};
}

// So many px along steps to the right and up. [Q10]
GlyphPoint offset_of(const TextStyle& style, ScreenOffset offset) noexcept;

// A gradient as the screen shows it. [Q14] A unit vector where cells are made
// of primitives, about that where they are made of samples, 0 if saturated.
struct ScreenGradient {
  int16_t right_q14;
  int16_t up_q14;
};

// What lies around a point: a radius on the screen, and what it is at the most
// along the axes of the glyph.
struct Surroundings {
  int32_t radius_q10;  // [px]
  uint32_t x_q16;      // [u]
  uint32_t y_q16;
};

class CellSampler {
 public:
  // Of a glyph of which a px is a u.
  explicit CellSampler(const GlyphField& field) noexcept
      : CellSampler(field, kScaleOfUnits, nullptr, kNoReach) {}
  // Vertices are rounded where that changes a distance up to `reach_q22`.
  CellSampler(const GlyphField& field,
              const TextStyle& style,
              int32_t reach_q22) noexcept;

  // Where a point lies, `offset` away from the centre of pixel (x, y). Steps
  // lead from it to the same point of other pixels, exactly: no picture depends
  // on where a row begins. False: farther from the origin than 2^15 u.
  bool find(const FinePoint& origin,
            int32_t x,
            int32_t y,
            ScreenOffset offset,
            GlyphPoint& out) const noexcept;
  GlyphPoint point(const FinePoint& origin,
                   int32_t x,
                   int32_t y,
                   ScreenOffset offset = {0, 0}) const noexcept {
    GlyphPoint at;
    find(origin, x, y, offset, at);
    return at;
  }

  // The distance on the screen, of primitives without a limit, else within +-32
  // px. [px, Q10]
  int32_t distance_q10(const GlyphPoint& at) noexcept;

  // The gradient in the glyph, and, of styles that do not stretch, on the
  // screen.
  Gradient glyph_gradient(const GlyphPoint& at) noexcept;
  ScreenGradient gradient(const GlyphPoint& at) noexcept;

  // Distance and gradient in the glyph, of a px of 1 u, by one descent.
  FieldPoint glyph_point(const GlyphPoint& at) noexcept;

  // Whether the last point lay in a cell that is saturated, or in none.
  bool is_saturated() const noexcept { return leaf_.count == 0; }
  bool is_saturated_inside() const noexcept {
    return leaf_.count == 0 && leaf_.is_inside;
  }

  // The width of that cell: 1 u beyond the grid. [log2, u]
  uint32_t cell_log2() const noexcept { return leaf_.size_log2; }

  // Whether the field is known to be a plane, or saturated, all around the last
  // point, `at`.
  bool is_plane_around(const GlyphPoint& at,
                       const Surroundings& around) const noexcept;

 private:
  CellSampler(const GlyphField& field,
              const FieldScale& scale,
              const TextStyle* style,
              int32_t reach_q22) noexcept;
  void seek(const GlyphPoint& at) noexcept;
  void evaluate(const PixelPlace& at, int32_t* values) const noexcept;
  bool are_primitives_plane(const GlyphPoint& at,
                            int32_t radius_q10) const noexcept;
  bool are_samples_plane(int32_t radius_q10) const noexcept;
  int32_t to_px_q10(int32_t distance_u_q10) const noexcept {
    return style_ == nullptr ? distance_u_q10
                             : style_->to_px_q10(distance_u_q10);
  }
  uint32_t mask() const noexcept { return (1u << (leaf_.size_log2 + 16)) - 1; }

  const GlyphField& field_;
  const TextStyle* style_;
  Csg csg_;
  // A point of the leaf: at first one outside of the grid.
  uint32_t x_u_ = UINT32_MAX;
  uint32_t y_u_ = UINT32_MAX;
  PlacedLeaf leaf_;
  ArcValue parts_[3];
  SamplesRow row_;
  uint32_t row_y_q16_ = 0;  // where row_ is set up
  bool has_row_ = false;
};

}  // namespace detail
}  // namespace inkcell
