// Distances along rows of cells of fields.
#pragma once

#include <stdint.h>

#include "field_cell.hpp"
#include "inkcell/field.hpp"
#include "order.hpp"
#include "row_terms.hpp"

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

  bool is_across() const noexcept { return normal == format::fields::kNormalY; }
};

// Evaluates rows of points, a px apart. A leaf is read once for its part of a
// row.
class FieldRow {
 public:
  // `step_q16` is what a px is in u.
  FieldRow(const GlyphField& field,
           const FieldScale& scale,
           int32_t reach_q22,
           int32_t step_q16) noexcept
      : scale_(scale),
        bend_shift_(scale.bend_log2 + 5),
        reach_q22_(reach_q22),
        step_q16_(static_cast<uint32_t>(step_q16)),
        field_(field) {}

  // A point of a row, from the origin.
  RowPoint point(int32_t x_q16, uint32_t x_q20) const noexcept {
    return {static_cast<uint32_t>(x_q16 - field_.x0_u * (1 << 16)), x_q20};
  }
  // To another row, in the same units.
  void go_to(int32_t y_q16, uint32_t y_q20) noexcept {
    y_u_ = static_cast<uint32_t>(y_q16 - field_.y0_u * (1 << 16)) >> 16;
    y_q8_ = static_cast<uint32_t>(wrapped(y_q20) >> 12);
  }

  // The coverage of `count` points from `at` on, which lie in the grid. False:
  // it is 0 everywhere.
  bool cover(RowPoint at,
             const CoverageRamp& ramp,
             uint8_t* out,
             int32_t count) const noexcept;

  // Three distances for each of `count` points: a way before it, at it, and
  // behind it, the outer two along the tangents of the fields of its own leaf,
  // which go on beyond it. All three are rounded as the middle one is. Where
  // that one is beyond way.far_q22 it is any of the same side, and the outer
  // two are not set.
  void take_thirds(RowPoint at,
                   const ThirdsWay& way,
                   int32_t* out,
                   int32_t count) const noexcept;
  ThirdsWay way(bool is_across, int32_t way_q8) const noexcept {
    return {is_across ? format::fields::kNormalY : format::fields::kNormalX,
            way_q8, reach_q22_ + magnitude(way_q8) * (1 << 14)};
  }

 private:
  // A leaf and its fields, as arc_bit() has them: three of them that differ
  // from the one before, or fewer. With `sign` -1 all values are negated, so
  // that there is only the least.
  struct RowLeaf {
    const uint8_t* field[3];  // those behind the last one are null
    int32_t sign;
    uint32_t size_log2;
    uint8_t count;  // 0: saturated
    bool is_nested;
    bool is_inside;  // if it is saturated

    bool has_lines() const noexcept {
      return (arc_bit(field[0]) | arc_bit(field[1]) | arc_bit(field[2])) == 0;
    }
    // False: it is saturated.
    bool begin(const Leaf& found) noexcept {
      field[1] = field[2] = nullptr;
      size_log2 = found.size_log2;
      count = 0;
      is_inside = found.reference == format::glyph::kInside;
      return found.reference >= format::glyph::kFirstNode;
    }
    // How the fields that were read are combined.
    void set(uint32_t field_count, FieldOperator op) noexcept {
      count = static_cast<uint8_t>(field_count);
      sign = -(static_cast<int32_t>(op) & 1);
      is_nested = op >= FieldOperator::least_of_greater;
    }
  };

  class Thirds;

  // Where a leaf ends along the row, or the row. [u, Q16]
  static uint32_t stop_of(const RowLeaf& leaf,
                          uint32_t x_q16,
                          uint32_t end_q16) noexcept {
    const uint32_t log2 = leaf.size_log2 + 16;
    const uint32_t stop_q16 = ((x_q16 >> log2) + 1) << log2;
    return stop_q16 < end_q16 ? stop_q16 : end_q16;
  }
  // The leaf that holds a point of the row, from the grid's left edge.
  void find_leaf(uint32_t x_q16, RowLeaf& leaf) const noexcept {
    if (field_.kind == GlyphField::Kind::narrow_fields) {
      find_narrow(x_q16 >> 16, leaf);
    } else {
      find_linked(x_q16 >> 16, leaf);
    }
  }
  void find_narrow(uint32_t x, RowLeaf& leaf) const noexcept;
  void find_linked(uint32_t x, RowLeaf& leaf) const noexcept;
  uint32_t tile_of(uint32_t x) const noexcept {
    return (y_u_ >> field_.tile_log2) * uint32_t{field_.tiles_x} +
           (x >> field_.tile_log2);
  }
  Vector gradient(const uint8_t* field, uint32_t x_q8) const noexcept;
  int32_t rounded(int32_t a,
                  const uint8_t* a_field,
                  int32_t b,
                  const uint8_t* b_field,
                  uint32_t x_q8) const noexcept;
  int32_t least_of_two(const RowLeaf& leaf,
                       int32_t a,
                       int32_t b,
                       uint32_t x_q8) const noexcept;
  int32_t least_of_three(const RowLeaf& leaf,
                         int32_t a,
                         int32_t b,
                         int32_t c,
                         uint32_t x_q8) const noexcept;
  int32_t rounded_three(const RowLeaf& leaf,
                        int32_t a,
                        int32_t b,
                        int32_t c,
                        uint32_t x_q8) const noexcept;
  bool is_near_vertex(int32_t lesser, int32_t greater) const noexcept {
    // Where the greater one is farther from 0 no vertex is near.
    return lesser < 0 && lesser > -reach_q22_ && lesser + greater < 0;
  }

  uint32_t y_q8_ = 0;
  FieldScale scale_;
  int32_t bend_shift_;
  int32_t reach_q22_;
  uint32_t step_q16_;
  const GlyphField& field_;
  uint32_t y_u_ = 0;
};

// The lesser of two values, with the leaf's sign.
__attribute__((always_inline)) inline int32_t FieldRow::least_of_two(
    const RowLeaf& leaf, int32_t a, int32_t b, uint32_t x_q8) const noexcept {
  const int32_t least = lesser(a, b);
  return least < 0 && least > -reach_q22_ && a + b < 0
             ? rounded(a, leaf.field[0], b, leaf.field[1], x_q8)
             : least;
}

// The least of three values, or what is left of them if they are nested.
__attribute__((always_inline)) inline int32_t FieldRow::least_of_three(
    const RowLeaf& leaf,
    int32_t a,
    int32_t b,
    int32_t c,
    uint32_t x_q8) const noexcept {
  const int32_t low = lesser(b, c);
  const int32_t high = greater(b, c);
  bool is_near = false;
  int32_t other = low;
  if (leaf.is_nested) {
    is_near = high > 0 && high < reach_q22_ && low + high > 0;
    other = high;
  }
  const bool is_first = a <= other;
  const int32_t least = is_first ? a : other;
  const int32_t second = is_first ? other : lesser(a, high);
  return is_near || is_near_vertex(least, second)
             ? rounded_three(leaf, a, b, c, x_q8)
             : least;
}

}  // namespace detail
}  // namespace inkcell
