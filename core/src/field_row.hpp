// Distances along rows of cells of fields.
#pragma once

#include <stdint.h>

#include "field_cell.hpp"
#include "field_combine.hpp"
#include "inkcell/field.hpp"

namespace inkcell {
namespace detail {

// Where a point lies along a row, in the two units that it takes to find a cell
// and to evaluate it.
struct RowPoint {
  uint32_t x_q16;  // from the grid's left edge [u]
  uint32_t x_q20;  // from the origin; may wrap [px]
};

// Evaluates rows of points, evenly spaced. A leaf is read once for its part of
// a row.
class FieldRow {
 public:
  FieldRow(const GlyphField& field,
           const FieldScale& scale,
           int32_t reach_q22,
           RowPoint step) noexcept
      : cells_(field.cells),
        scale_(scale),
        bend_shift_(scale.bend_log2 + 5),
        reach_q22_(reach_q22),
        step_(step),
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

  // The distances of `count` points, from `at` on, which lie in the grid;
  // beyond the reach any of the same side. [px, Q22] Each point is evaluated
  // for itself, and no further than to the first field that decides it.
  void take(RowPoint at, int32_t* out, int32_t count) const noexcept;

  // Three distances for each of `count` points: a third of a pixel before it,
  // at it, and behind it; all by the fields of its own leaf, which go on beyond
  // it. Where the middle one is farther than thirds_reach_q22() it stands for
  // all three. Vertices are rounded within the reach.
  void take_thirds(RowPoint at, int32_t* out, int32_t count) const noexcept;
  int32_t thirds_reach_q22() const noexcept {
    return reach_q22_ + kThirdQ8 * (1 << 14);
  }

 private:
  // The fields of a leaf. A field's place is that of its record, in bytes from
  // the first; plus 1 if it is an arc. With `sign` -1 all values are negated,
  // so that there is only the least.
  struct Fields {
    uint32_t place[3];
    int32_t sign;
    bool is_nested;

    void set(FieldOperator op) noexcept {
      sign = -(static_cast<int32_t>(op) & 1);
      is_nested = op >= FieldOperator::least_of_greater;
    }
  };
  struct Operand {
    int32_t value_q22;
    uint32_t place;
  };
  static constexpr int32_t kThirdQ8 = 85;

  class PlainValues;
  class NearValues;

  template <typename Values>
  void take_with(RowPoint at, int32_t* out, int32_t count) const noexcept;
  template <typename Values>
  int32_t of_two(const Values& values, uint32_t x_q8) const noexcept;
  template <typename Values>
  int32_t of_three(const Values& values, uint32_t x_q8) const noexcept;

  uint32_t place_of(uint32_t number) const noexcept;
  uint32_t read_narrow(uint32_t reference, Fields& fields) const noexcept;
  uint32_t read_linked(uint32_t reference, Fields& fields) const noexcept;
  void set_up(uint32_t place, uint32_t x_q8, FieldTerm& term) const noexcept;
  int32_t rounded(const Operand& a,
                  const Operand& b,
                  uint32_t x_q8) const noexcept;
  int32_t rounded_two(const Fields& fields,
                      int32_t a,
                      int32_t b,
                      uint32_t x_q8) const noexcept;
  int32_t rounded_three(const Fields& fields,
                        int32_t a,
                        int32_t b,
                        int32_t c,
                        uint32_t x_q8) const noexcept;
  bool is_near_vertex(int32_t lesser, int32_t greater) const noexcept {
    // Where the greater one is farther from 0 no vertex is near.
    return lesser < 0 && lesser > -reach_q22_ && lesser + greater < 0;
  }

  const uint8_t* cells_;
  uint32_t y_q8_ = 0;
  FieldScale scale_;
  int32_t bend_shift_;
  int32_t reach_q22_;
  RowPoint step_;
  const GlyphField& field_;
  uint32_t y_u_ = 0;
};

inline uint32_t FieldRow::place_of(uint32_t number) const noexcept {
  using format::fields::kArcBytes;
  using format::fields::kLineBytes;
  const uint32_t arcs = field_.arc_count;
  return number < arcs ? kArcBytes * number + 1
                       : kLineBytes * number + (kArcBytes - kLineBytes) * arcs;
}

inline uint32_t FieldRow::read_narrow(uint32_t reference,
                                      Fields& fields) const noexcept {
  FieldOperator op = FieldOperator::least;
  const uint32_t count = read_narrow_leaf(
      field_, reference, [this](uint32_t number) { return place_of(number); },
      fields.place, op);
  fields.set(op);
  return count;
}

// Of the values with the leaf's sign. Values::distance gives them, and
// Values::far_q22 how far they must be true.
template <typename Values>
inline int32_t FieldRow::of_two(const Values& values,
                                uint32_t x_q8) const noexcept {
  const int32_t sign = values.fields.sign;
  const int32_t a = with_sign(values.distance(0, x_q8), sign);
  int32_t least = a;
  if (a > -values.far_q22()) {
    const int32_t b = with_sign(values.distance(1, x_q8), sign);
    const bool in_order = a <= b;
    least = in_order ? a : b;
    if (is_near_vertex(least, in_order ? b : a)) {
      least = rounded_two(values.fields, a, b, x_q8);
    }
  }
  return with_sign(least, sign);
}

template <typename Values>
inline int32_t FieldRow::of_three(const Values& values,
                                  uint32_t x_q8) const noexcept {
  const int32_t sign = values.fields.sign;
  const int32_t a = with_sign(values.distance(0, x_q8), sign);
  int32_t least = a;
  if (a > -values.far_q22()) {
    const int32_t b = with_sign(values.distance(1, x_q8), sign);
    const int32_t c = with_sign(values.distance(2, x_q8), sign);
    const bool in_order = b <= c;
    const int32_t low = in_order ? b : c;
    const int32_t high = in_order ? c : b;
    bool is_near = false;
    int32_t other = low;
    if (values.fields.is_nested) {
      is_near = high > 0 && high < reach_q22_ && low + high > 0;
      other = high;
    }
    const bool is_first = a <= other;
    least = is_first ? a : other;
    const int32_t second = is_first ? other : (a <= high ? a : high);
    if (is_near || is_near_vertex(least, second)) {
      least = rounded_three(values.fields, a, b, c, x_q8);
    }
  }
  return with_sign(least, sign);
}

template <typename Values>
inline void FieldRow::take_with(RowPoint at,
                                int32_t* out,
                                int32_t count) const noexcept {
  uint32_t x_q16 = at.x_q16;
  uint32_t x_q20 = at.x_q20;
  const RowPoint step = step_;
  const uint32_t end_q16 = x_q16 + static_cast<uint32_t>(count) * step.x_q16;
  const uint32_t first_tile =
      (y_u_ >> field_.tile_log2) * uint32_t{field_.tiles_x};
  const bool is_narrow = field_.kind == GlyphField::Kind::narrow_fields;
  while (x_q16 < end_q16) {
    const uint32_t x = x_q16 >> 16;
    const uint32_t tile = first_tile + (x >> field_.tile_log2);
    const Leaf found = is_narrow ? find_narrow_leaf(field_, tile, x, y_u_)
                                 : LinkedHeap(field_).find_leaf(
                                       tile, field_.tile_log2, x, y_u_);
    const uint32_t log2 = found.size_log2 + 16;
    uint32_t stop_q16 = ((x_q16 >> log2) + 1) << log2;
    stop_q16 = stop_q16 < end_q16 ? stop_q16 : end_q16;
    Values values(*this);
    uint32_t fields = 0;
    if (found.reference >= format::glyph::kFirstNode) {
      fields = is_narrow ? read_narrow(found.reference, values.fields)
                         : read_linked(found.reference, values.fields);
    }
    const auto points = [&](const auto& distance) {
      do {
        out = values.put(static_cast<uint32_t>(wrapped(x_q20) >> 12), out,
                         distance);
        x_q20 += step.x_q20;
        x_q16 += step.x_q16;
      } while (x_q16 < stop_q16);
    };
    values.begin(fields, static_cast<uint32_t>(wrapped(x_q20) >> 12));
    if (fields == 1) {
      points([&](uint32_t x_q8) { return values.distance(0, x_q8); });
    } else if (fields == 2) {
      points([&](uint32_t x_q8) { return of_two(values, x_q8); });
    } else if (fields == 3) {
      points([&](uint32_t x_q8) { return of_three(values, x_q8); });
    } else {
      const int32_t side =
          found.reference == format::glyph::kInside ? INT32_MAX : INT32_MIN;
      points([side](uint32_t) { return side; });
    }
  }
}

}  // namespace detail
}  // namespace inkcell
