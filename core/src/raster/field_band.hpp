// Bands of upright cells of primitives.
#pragma once

#include <stdint.h>

#include "raster/leaf_band.hpp"

namespace inkcell {
namespace detail {

// Draws bands of points, a px apart.
class FieldBand : public LeafBand {
 public:
  FieldBand(const GlyphField& field, const TextStyle& style) noexcept
      : LeafBand(
            field, scale_of(style), style.filter(), reach_of(style.filter())),
        step_q16_(static_cast<uint32_t>(style.step_along_q16())) {}

  // To a band by its first point, from the origin.
  void go_to(const FieldPosition& at) noexcept {
    left_q16_ = static_cast<uint32_t>(at.x_q16 - field_.x0_u * (1 << 16));
    top_q16_ = static_cast<uint32_t>(at.y_q16 - field_.y0_u * (1 << 16));
    left_q8_ = q8_of(at.x_q20);
    top_q8_ = q8_of(at.y_q20);
  }
  // As many points to the right.
  void go_right(int32_t count) noexcept {
    left_q16_ += static_cast<uint32_t>(count) * step_q16_;
    left_q8_ += static_cast<uint32_t>(count) << 8;
  }

  // The coverage of its points, all in the grid, in lines of Pixels that are
  // clear. False: it is 0 everywhere.
  bool cover(int32_t width, int32_t height, uint8_t* lines) const noexcept;

 private:
  // Its points form a box.
  struct BoxLeaf : BandLeaf {
    uint16_t width;
    uint16_t row;  // the first one
  };

  // How many points lie no further on than `way_q16`, the first of them at 0;
  // `most` at the most. [u]
  int32_t points_upto(uint32_t way_q16, int32_t most) const noexcept;
  // Where a row lies. [u]
  uint32_t height_q16(int32_t row) const noexcept {
    return top_q16_ - static_cast<uint32_t>(row) * step_q16_;
  }
  // The same in px, modulo 2^24.
  uint32_t height_q8(int32_t row) const noexcept {
    return top_q8_ - (static_cast<uint32_t>(row) << 8);
  }
  uint8_t coverage_of_point(const FieldLeaf& leaf) const noexcept;
  void paint_leaf(BoxLeaf& leaf) const noexcept;
  template <typename Terms>
  void paint(BoxLeaf& leaf) const noexcept;

  void reduce_box(BoxLeaf& leaf) const noexcept;

  uint32_t step_q16_;  // what a px is in u
  // Where the first point lies, from the grid's corner [u] and the origin [px].
  // Nothing until the first `go_to`.
  uint32_t left_q16_;
  uint32_t top_q16_;
  uint32_t left_q8_;
  uint32_t top_q8_;
};

}  // namespace detail
}  // namespace inkcell
