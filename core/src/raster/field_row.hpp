// Distances along rows of points, three for each.
#pragma once

#include <stdint.h>

#include "distance/field_leaves.hpp"

namespace inkcell {
namespace detail {

// Where a point lies along a row, in the two units that it takes to find a cell
// and to evaluate it.
struct RowPoint {
  uint32_t x_q16;  // from the grid's left edge [u]
  uint32_t x_q20;  // from the origin; may wrap [px]
};

// How points of a row lead to those before and behind them: along the row, or
// across it.
struct ThirdsWay {
  uint32_t normal;  // where a record has that along the way
  int32_t way_q8;   // to the one behind, and upwards [px]
  int32_t far_q22;  // beyond it only the one in the middle counts [px]

  bool is_across() const noexcept { return normal == format::edges::kNormalY; }
};

// Evaluates rows of points, a px apart. A leaf is read once for its part of a
// row.
class FieldRow : public FieldLeaves {
 public:
  FieldRow(const GlyphField& field,
           const TextStyle& style,
           int32_t reach_q22) noexcept
      : FieldLeaves(field, scale_of(style), reach_q22),
        step_q16_(static_cast<uint32_t>(style.step_along_q16())) {}

  // A point of a row, from the origin.
  RowPoint point(int32_t x_q16, uint32_t x_q20) const noexcept {
    return {static_cast<uint32_t>(x_q16 - field_.x0_u * (1 << 16)), x_q20};
  }

  // To another row, in the same units.
  void go_to(int32_t y_q16, uint32_t y_q20) noexcept {
    y_u_ = static_cast<uint32_t>(y_q16 - field_.y0_u * (1 << 16)) >> 16;
    y_q8_ = static_cast<uint32_t>(wrapped(y_q20) >> 12);
  }

  // Three distances for each of `count` points from `at` on, which lie in the
  // grid: a way before it, at it, and behind it, the outer two along the
  // tangents of the fields of its own leaf, which go on beyond it. All three
  // are rounded as the middle one is. Where that one is beyond way.far_q22 it
  // is any of the same side, and the outer two are not set. A row has kMaxSpan
  // points at the most.
  void take_thirds(RowPoint at,
                   const ThirdsWay& way,
                   int32_t* out,
                   int32_t count) const noexcept;
  ThirdsWay way(bool is_across, int32_t way_q8) const noexcept {
    return {is_across ? format::edges::kNormalY : format::edges::kNormalX,
            way_q8, reach_q22_ + abs(way_q8) * (1 << 14)};
  }

 private:
  class Thirds;

  // Where a leaf ends along the row, or the row. [u, Q16]
  static uint32_t stop_of(const FieldLeaf& leaf,
                          uint32_t x_q16,
                          uint32_t end_q16) noexcept {
    const uint32_t log2 = leaf.size_log2 + 16;
    const uint32_t stop_q16 = ((x_q16 >> log2) + 1) << log2;
    return stop_q16 < end_q16 ? stop_q16 : end_q16;
  }

  uint32_t step_q16_;  // what a px is in u
  uint32_t y_u_ = 0;
  uint32_t y_q8_ = 0;
};

}  // namespace detail
}  // namespace inkcell
