// Blocks of pixels of cells of fields, followed from row to row.
#pragma once

#include <stdint.h>

#include "field_combine.hpp"

namespace inkcell {
namespace detail {

// Whole pixels of the glyph's box: columns from the left, rows from the top.
struct Block {
  int32_t left;
  int32_t top;
  int32_t right;
  int32_t bottom;
};

// The largest block: no product of a slope and a way wraps. [px]
inline constexpr int32_t kMaxBlockSide = 128;

// Draws blocks of leaves.
class BlockPainter {
 public:
  // The glyph's box of pixels, whose upper left pixel is at `first`.
  BlockPainter(FieldPage& page,
               const Rect& pixels,
               const PixelPlace& first) noexcept
      : page_(page), x0_(pixels.x0), y0_(pixels.y0), first_(first) {}

  // A block that is all inside.
  void fill(const Block& block) noexcept;

  // A block of a leaf that has fields, at most kMaxBlockSide wide and high.
  void draw(LeafFields leaf, const Block& block) noexcept;

 private:
  // What a block shows: nothing, all, or what its distances say.
  enum class Side : uint8_t { outside, edge, inside };

  // A field at a pixel.
  struct Spot {
    uint32_t plane_q22;
    uint32_t along_q22;
  };

  // A field on its way through a block.
  struct Track {
    Spot row;         // the first pixel of the row
    uint32_t dx_q22;  // n, by which the plane changes in a pixel
    uint32_t dy_q22;
    int32_t bend;
    // From here on, and up to here, the rest of a row is saturated; for values
    // with the leaf's sign.
    int32_t inside_q22;
    int32_t outside_q22;
    uint16_t unit;

    void move_right(Spot& spot, uint32_t pixels) const noexcept {
      spot.plane_q22 += pixels * dx_q22;
      spot.along_q22 -= pixels * dy_q22;
    }
    void move_right(Spot& spot) const noexcept {
      spot.plane_q22 += dx_q22;
      spot.along_q22 -= dy_q22;
    }
    void move_down() noexcept {
      row.plane_q22 -= dy_q22;
      row.along_q22 -= dx_q22;
    }
  };

  int32_t value_q22(const Track& track, const Spot& spot) const noexcept {
    const FieldTerm term = {spot.plane_q22, track.bend, spot.along_q22, 0, 0};
    return with_sign(term.value_q22(page_.scale.bend_log2), sign_);
  }
  PixelPlace place_of(const Block& block) const noexcept {
    return {first_.x_q8 + (static_cast<uint32_t>(block.left) << 8),
            first_.y_q8 - (static_cast<uint32_t>(block.top) << 8)};
  }
  Side set_up(Track& track, int32_t sign, const Block& block) noexcept;
  Side set_up_all(LeafFields& leaf, const Block& block) noexcept;
  void draw_single(const Track& track,
                   Spot spot,
                   int32_t x,
                   int32_t end) noexcept;
  void draw_pair(const Track& a,
                 const Track& b,
                 PixelPlace place,
                 int32_t x,
                 int32_t end) noexcept;
  void draw_triple(const LeafFields& leaf,
                   PixelPlace place,
                   int32_t x,
                   int32_t end) noexcept;
  void draw_three(const LeafFields& leaf,
                  PixelPlace place,
                  int32_t x,
                  int32_t end) noexcept;
  Side side_of(uint32_t i) const noexcept;
  void saturate(int32_t x, int32_t end, bool inside) noexcept;
  void put(int32_t value_q22, int32_t x) noexcept;
  bool is_on_ramp(int32_t value_q22) const noexcept;
  int32_t skipped(int32_t value_q22) const noexcept;

  FieldPage& page_;
  int32_t x0_;
  int32_t y0_;
  PixelPlace first_;
  // Of the block.
  Track tracks_[3];
  int32_t sign_ = 0;
  int32_t slope_q14_ = 0;
  int32_t margin_q22_ = 0;
  uint32_t pixels_per_slope_ = 0;
};

}  // namespace detail
}  // namespace inkcell
