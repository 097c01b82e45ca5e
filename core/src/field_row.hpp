// Distances along rows of cells of fields.
#pragma once

#include <stdint.h>

#include "field_cell.hpp"
#include "inkcell/field.hpp"
#include "order.hpp"

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

  class PlainValues;
  class ThirdValues;

  template <typename Values, typename... More>
  void take_with(RowPoint at,
                 int32_t* out,
                 int32_t count,
                 const More&... more) const noexcept;
  int32_t value(uint32_t place, uint32_t x_q8) const noexcept;
  uint32_t place_of(uint32_t number) const noexcept;
  uint32_t read_narrow(uint32_t reference, Fields& fields) const noexcept;
  uint32_t read_linked(uint32_t reference, Fields& fields) const noexcept;
  Vector gradient(uint32_t place, uint32_t x_q8) const noexcept;
  int32_t rounded(int32_t a,
                  uint32_t a_place,
                  int32_t b,
                  uint32_t b_place,
                  uint32_t x_q8) const noexcept;
  int32_t least_of_three(const Fields& fields,
                         int32_t a,
                         int32_t b,
                         int32_t c,
                         uint32_t x_q8) const noexcept;
  int32_t rounded_two(const Fields& fields,
                      int32_t a,
                      int32_t b,
                      uint32_t x_q8) const noexcept {
    return rounded(a, fields.place[0], b, fields.place[1], x_q8);
  }
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

// The value of a field, FieldTerm::value_q22, in one step.
__attribute__((always_inline)) inline int32_t FieldRow::value(
    uint32_t place, uint32_t x_q8) const noexcept {
  namespace layout = format::fields;
  const uint8_t* const at = cells_ + (place & ~uint32_t{1});
  const int32_t nx = load_i16(at + layout::kNormalX);
  const int32_t ny = load_i16(at + layout::kNormalY);
  uint32_t value = times(nx, x_q8) + times(ny, y_q8_) +
                   times(load_i16(at + layout::kOffset), scale_.size_q8);
  if ((place & 1) != 0) {
    const auto along = static_cast<uint32_t>(
        wrapped(times(nx, y_q8_) - times(ny, x_q8) + (1 << 13) +
                times(load_i16(at + layout::kAlong), scale_.size_q8)) >>
        14);
    const int32_t bend =
        (load_i16(at + layout::kBend) * scale_.bend_q14 + (1 << 10)) >> 11;
    const auto half_q15 =
        static_cast<uint32_t>(wrapped(times(bend, along)) >> bend_shift_);
    value += static_cast<uint32_t>(wrapped(half_q15 * along) >> 1);
  }
  return wrapped(value);
}

// The least of three values, or what is left of them if they are nested.
__attribute__((always_inline)) inline int32_t FieldRow::least_of_three(
    const Fields& fields,
    int32_t a,
    int32_t b,
    int32_t c,
    uint32_t x_q8) const noexcept {
  const bool in_order = b <= c;
  const int32_t low = in_order ? b : c;
  const int32_t high = in_order ? c : b;
  bool is_near = false;
  int32_t other = low;
  if (fields.is_nested) {
    is_near = high > 0 && high < reach_q22_ && low + high > 0;
    other = high;
  }
  const bool is_first = a <= other;
  const int32_t least = is_first ? a : other;
  const int32_t second = is_first ? other : (a <= high ? a : high);
  return is_near || is_near_vertex(least, second)
             ? rounded_three(fields, a, b, c, x_q8)
             : least;
}

template <typename Values, typename... More>
__attribute__((always_inline)) inline void FieldRow::take_with(
    RowPoint at,
    int32_t* out,
    int32_t count,
    const More&... more) const noexcept {
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
    Values values(*this, more...);
    uint32_t fields = 0;
    if (found.reference >= format::glyph::kFirstNode) {
      fields = is_narrow ? read_narrow(found.reference, values.fields)
                         : read_linked(found.reference, values.fields);
      values.set_up(fields);
    }
    const auto points = [&](const auto& put) __attribute__((always_inline)) {
      do {
        out = put(static_cast<uint32_t>(wrapped(x_q20) >> 12), out);
        x_q20 += step.x_q20;
        x_q16 += step.x_q16;
      } while (x_q16 < stop_q16);
    };
    if (fields == 1) {
      points([&](uint32_t x_q8, int32_t* to) { return values.one(x_q8, to); });
    } else if (fields == 2) {
      points([&](uint32_t x_q8, int32_t* to) { return values.two(x_q8, to); });
    } else if (fields == 3) {
      points(
          [&](uint32_t x_q8, int32_t* to) { return values.three(x_q8, to); });
    } else {
      const int32_t side =
          found.reference == format::glyph::kInside ? INT32_MAX : INT32_MIN;
      points([side](uint32_t, int32_t* to) { return Values::side(side, to); });
    }
  }
}

}  // namespace detail
}  // namespace inkcell
