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

// The largest block: a row of it makes one span. [px]
inline constexpr int32_t kMaxBlockSide = kMaxSpan;

// Draws blocks of leaves.
class BlockPainter {
 public:
  // The glyph's box of pixels, whose upper left pixel is at `first`.
  BlockPainter(const FieldPage& page,
               const Sink& sink,
               const Rect& pixels,
               const PixelPlace& first) noexcept;

  // A block that is all inside.
  void fill(const Block& block) noexcept;

  // A block of a leaf that has fields, at most kMaxBlockSide wide and high.
  // False: nothing was drawn, and the block became narrower: the rest of it is
  // a block of its own. `leaf` is changed.
  bool draw(LeafFields& leaf, Block& block) noexcept;

 private:
  // What a field or all of them show: nothing, all, or what distances say.
  enum class Side : uint8_t { outside, edge, inside };

  // A field at a pixel, or what leads from one to another.
  struct Spot {
    uint32_t plane_q22;
    uint32_t along_q22;

    Spot plus(const Spot& way) const noexcept {
      return {plane_q22 + way.plane_q22, along_q22 + way.along_q22};
    }
    Spot minus(const Spot& way) const noexcept {
      return {plane_q22 - way.plane_q22, along_q22 - way.along_q22};
    }
    Spot times(int32_t count) const noexcept {
      const auto n = static_cast<uint32_t>(count);
      return {n * plane_q22, n * along_q22};
    }
  };

  // A field on its way through a block, and into the shape: to the right or to
  // the left.
  struct Track {
    Spot spot;     // the first pixel of the row that is not outside
    Spot further;  // what a pixel on adds
    Spot down;     // what a row down takes off
    int32_t bend;
    int32_t margin_q22;  // how far beyond the ramp the rest is saturated
    uint16_t unit;
    int8_t rest;       // pixels behind that one in the block
    bool is_left : 1;  // the way goes to the left
    bool is_wavy : 1;  // or there and back: `spot` is where the row begins
  };

  // The pixels of a row that are not outside. Those in the middle are inside,
  // the others in the buffer.
  struct Row {
    int32_t begin;
    int32_t solid_begin;
    int32_t solid_end;
    int32_t end;
  };

  // What becomes of distances: Filter, as the inner loops read it.
  struct Ramp {
    int32_t outside_q10;
    uint32_t length_q10;
    uint32_t scale;
  };

  int32_t value_q22(int32_t bend, const Spot& spot) const noexcept;
  uint8_t coverage(int32_t value_q22) const noexcept;
  int32_t x_of(const Track& track) const noexcept;
  Spot spot_at(const Track& track, int32_t x) const noexcept;
  Side set_up(Track& track, uint32_t unit) noexcept;
  Side set_up_all(LeafFields& leaf) noexcept;
  bool is_steady(uint32_t count) const noexcept;
  Side follow(Track& track) const noexcept;
  void draw_lone(int32_t y, int32_t end_y) noexcept;
  int32_t draw_ramp(const Track& track, int32_t most) noexcept;
  int32_t draw_both(const Track& a,
                    const Track& b,
                    int32_t begin,
                    int32_t end) noexcept;
  void narrow(const Track& track, int32_t& begin, int32_t& end) const noexcept;
  Row single_row(const Track& track) noexcept;
  Row pair_row(const Track& a, const Track& b) noexcept;
  Row triple_row(const LeafFields& leaf) noexcept;
  Row several_row(const LeafFields& leaf) noexcept;
  void hand_over(const Row& row, int32_t y) noexcept;
  int32_t solid(int32_t from, int32_t begin, int32_t end, int32_t y) noexcept;
  void span(int32_t begin, int32_t end, int32_t y) noexcept;

  Row outside_row() const noexcept { return {width_, width_, width_, width_}; }
  Row inside_row() const noexcept { return {0, 0, width_, width_}; }

  const FieldPage& page_;
  const Sink& sink_;
  PixelPlace first_;
  int32_t x0_;
  int32_t y0_;
  int32_t bend_shift_;
  Ramp ramp_ = {};
  // Of the block.
  int32_t width_ = 0;
  int32_t height_ = 0;
  int32_t left_ = 0;         // on the screen
  int32_t cut_ = 0;          // where it is better cut in two
  int32_t sign_ = 0;         // of the leaf
  int32_t outside_q22_ = 0;  // the greatest value that is outside
  PixelPlace place_ = {};    // of the row's first pixel
  Track tracks_[3];
  uint8_t buffer_[kMaxBlockSide];
};

inline int32_t BlockPainter::value_q22(int32_t bend,
                                       const Spot& spot) const noexcept {
  if (bend == 0) {
    return wrapped(spot.plane_q22);
  }
  const auto along = static_cast<uint32_t>(wrapped(spot.along_q22) >> 14);
  const int32_t slope_q15 = wrapped(times(bend, along)) >> bend_shift_;
  const int32_t sag_q22 = wrapped(times(slope_q15, along)) >> 1;
  return wrapped(spot.plane_q22 +
                 static_cast<uint32_t>(with_sign(sag_q22, sign_)));
}

// Filter::coverage.
inline uint8_t BlockPainter::coverage(int32_t value_q22) const noexcept {
  const int32_t way_q10 =
      (with_sign(value_q22, sign_) >> 12) - ramp_.outside_q10;
  const auto way = static_cast<uint32_t>(way_q10);
  if (way < ramp_.length_q10) {
    return page_.filter.table[static_cast<uint8_t>((way * ramp_.scale) >> 14)];
  }
  return way_q10 < 0 ? 0 : 255;
}

}  // namespace detail
}  // namespace inkcell
