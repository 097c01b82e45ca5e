// Blocks of pixels of cells of fields, followed from row to row.
#pragma once

#include <stdint.h>

#include "field_cell.hpp"
#include "inkcell/brush.hpp"
#include "inkcell/filter.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace detail {

// The largest block: a row of it makes one span. [px]
inline constexpr int32_t kMaxBlockSide = kMaxSpan;

// The fields of a leaf.
struct LeafFields {
  uint16_t units[3];
  uint8_t count;
  FieldOperator op;
};

// Draws blocks of leaves. Whatever a row needs is a member, which keeps the
// frames on the stack small.
class BlockPainter {
 public:
  BlockPainter(const GlyphField& field,
               const Brush& brush,
               const Sink& sink) noexcept;

  // Where the screen's pixel (0, 0) is; may wrap.
  void set_origin(const PixelPlace& origin) noexcept { origin_ = origin; }

  const GlyphField& field() const noexcept { return field_; }
  uint32_t size_q8() const noexcept { return size_q8_; }
  const Sink& sink() const noexcept { return sink_; }

  // A block that is all inside.
  void fill(const Rect& block) noexcept;

  // A block of a leaf that has fields, at most kMaxBlockSide wide and high, or
  // its left part: `block` becomes what was drawn.
  void draw(const LeafFields& leaf, Rect& block) noexcept;

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
    int32_t value_q22;   // at a pixel where fields are combined
    uint16_t unit;
    int8_t rest;       // pixels behind that one in the block
    bool is_left : 1;  // the way goes to the left
    bool is_wavy : 1;  // or there and back: `spot` is where the row begins
  };

  // The pixels of a row that are not outside. Those in the middle are inside,
  // the others in the buffer.
  struct Row {
    uint8_t begin;
    uint8_t solid_begin;
    uint8_t solid_end;
    uint8_t end;
  };

  static Row row(int32_t begin,
                 int32_t solid_begin,
                 int32_t solid_end,
                 int32_t end) noexcept {
    return {static_cast<uint8_t>(begin), static_cast<uint8_t>(solid_begin),
            static_cast<uint8_t>(solid_end), static_cast<uint8_t>(end)};
  }

  // Sets of tracks: bit i is track i. With kNone all is outside, and with no
  // bit inside.
  static constexpr uint32_t kAll = 7;
  static constexpr uint32_t kNone = 8;

  // What becomes of distances: Filter, as the inner loops read it.
  struct Ramp {
    int16_t outside_q10;
    uint16_t length_q10;
    uint16_t scale;
  };

  int32_t slope_q15(int32_t bend, uint32_t along_q22) const noexcept;
  int32_t value_q22(int32_t bend, const Spot& spot) const noexcept;
  uint8_t coverage(int32_t value_q22) const noexcept;
  int32_t x_of(const Track& track) const noexcept;
  int32_t way_to(const Track& track, int32_t x) const noexcept;
  Spot spot_at(const Track& track, int32_t x) const noexcept;
  Side set_up(Track& track, uint32_t unit, const PixelPlace& place) noexcept;
  Side set_up_all(const LeafFields& leaf, const PixelPlace& place) noexcept;
  bool is_steady() const noexcept;
  Side follow(Track& track) const noexcept;
  Vector gradient_q14(const Track& track, int32_t x) const noexcept;
  int32_t rounded(const Track& lesser,
                  const Track& greater,
                  int32_t x) const noexcept;
  int32_t least(const Track& a, const Track& b, int32_t x) const noexcept;
  int32_t least_of_three(int32_t x) noexcept;
  void draw_lone(int32_t y, int32_t end_y) noexcept;
  int32_t draw_ramp(const Track& track, int32_t most) noexcept;
  int32_t draw_both(Track& a, Track& b, int32_t begin, int32_t end) noexcept;
  int32_t begin_of(const Track& track) const noexcept;
  int32_t end_of(const Track& track) const noexcept;
  void set_outside() noexcept;
  void single_row(const Track& track) noexcept;
  void pair_row(Track& a, Track& b) noexcept;
  void triple_row() noexcept;
  uint32_t follow_all() noexcept;
  void next_row() noexcept;
  void hand_over(int32_t y) noexcept;
  int32_t solid(int32_t from, int32_t begin, int32_t end, int32_t y) noexcept;
  void span(int32_t begin, int32_t end, int32_t y) noexcept;

  uint8_t buffer_[kMaxBlockSide];
  // Of the block.
  int32_t width_ = 0;
  int32_t sign_ = 0;         // -1: all values are negated
  int32_t outside_q22_ = 0;  // the greatest value that is outside
  int32_t left_ = 0;         // on the screen
  uint8_t height_ = 0;
  uint8_t cut_ = 0;    // where it is better cut in two
  uint8_t count_ = 0;  // fields that matter
  bool is_nested_ = false;
  Row row_ = {};
  // Of the glyph.
  const GlyphField& field_;
  const Filter& filter_;
  const Sink& sink_;
  PixelPlace origin_ = {};
  uint32_t size_q8_;
  int32_t bend_q14_;
  int32_t reach_q22_;
  Ramp ramp_;
  uint8_t bend_shift_;

  Track tracks_[3];
};

// FieldTerm::slope_q15.
inline int32_t BlockPainter::slope_q15(int32_t bend,
                                       uint32_t along_q22) const noexcept {
  const auto along_q8 = static_cast<uint32_t>(wrapped(along_q22) >> 14);
  return wrapped(times(bend, along_q8)) >> bend_shift_;
}

inline int32_t BlockPainter::value_q22(int32_t bend,
                                       const Spot& spot) const noexcept {
  if (bend == 0) {
    return wrapped(spot.plane_q22);
  }
  const auto along_q8 = static_cast<uint32_t>(wrapped(spot.along_q22) >> 14);
  const int32_t sag_q22 =
      wrapped(times(slope_q15(bend, spot.along_q22), along_q8)) >> 1;
  return wrapped(spot.plane_q22 +
                 static_cast<uint32_t>(with_sign(sag_q22, sign_)));
}

// Filter::coverage.
inline uint8_t BlockPainter::coverage(int32_t value_q22) const noexcept {
  const int32_t way_q10 =
      (with_sign(value_q22, sign_) >> 12) - ramp_.outside_q10;
  const auto way = static_cast<uint32_t>(way_q10);
  if (way < ramp_.length_q10) {
    return filter_.table[static_cast<uint8_t>((way * ramp_.scale) >> 14)];
  }
  return way_q10 < 0 ? 0 : 255;
}

}  // namespace detail
}  // namespace inkcell
