// How the fields of a leaf make one distance, for the loops that draw them.
#pragma once

#include <stdint.h>

#include "field_cell.hpp"
#include "field_draw.hpp"
#include "inkcell/filter.hpp"

namespace inkcell {
namespace detail {

// What all pixels of a glyph have in common.
struct FieldPage {
  const GlyphField& field;
  const Filter& filter;
  FieldScale scale;
  int32_t reach_q22;
  int32_t step_q16;
};

// The fields of a leaf. With `sign` -1 all values are negated, so that there is
// only the least.
struct LeafFields {
  uint16_t units[3];
  bool is_nested;
  uint32_t count;
  int32_t sign;
};

// -value if `sign` is -1, value if it is 0; may wrap.
inline int32_t with_sign(int32_t value, int32_t sign) noexcept {
  return wrapped(static_cast<uint32_t>(value ^ sign) -
                 static_cast<uint32_t>(sign));
}

// Where a pixel lies in the glyph. [px, Q8]
struct PixelPlace {
  uint32_t x_q8;
  uint32_t y_q8;
};

// The lesser of the values of fields i and j, rounded at their vertex: what is
// rarely needed is set up anew.
int32_t rounded_at(const FieldPage& page,
                   const LeafFields& leaf,
                   uint32_t i,
                   uint32_t j,
                   const int32_t* values,
                   PixelPlace place) noexcept;

// The distance of a leaf of two or three fields from their values with the
// leaf's sign, which may be changed. It has that sign, too.
int32_t combined(const FieldPage& page,
                 const LeafFields& leaf,
                 int32_t* values,
                 PixelPlace place) noexcept;

// What a leaf names: no fields, if one does not exist.
template <bool kNarrow>
inline void read_leaf(const GlyphField& field,
                      uint32_t reference,
                      LeafFields& leaf) noexcept {
  FieldOperator op = FieldOperator::least;
  leaf.count = kNarrow ? read_narrow_leaf(field, reference, leaf.units, op)
                       : read_linked_leaf(field, reference, leaf.units, op);
  leaf.sign = -(static_cast<int32_t>(op) & 1);
  leaf.is_nested = op >= FieldOperator::least_of_greater;
}

// Draws cell after cell: fastest where cells have many pixels.
void draw_by_cells(const FieldPage& page,
                   const Upright& upright,
                   const Sink& sink) noexcept;

}  // namespace detail
}  // namespace inkcell
