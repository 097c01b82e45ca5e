// A leaf of cells of primitives, as it is drawn.
#pragma once

#include <stdint.h>

#include "cells/field_cell.hpp"
#include "distance/row_terms.hpp"
#include "inkcell/field.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace detail {

// A leaf and its fields, as arc_bit() has them. With `sign` -1 all values are
// negated, so that there is only the least.
struct FieldLeaf {
  // Sets nothing: begin() and set() do. Not `= default`: a type that has a
  // constructor lends the bytes behind its members to what derives from it.
  FieldLeaf() noexcept {}

  const uint8_t* field[3];
  PixelPlace place;  // of its first point in the row, or of one to be rounded
  uint8_t size_log2;
  uint8_t count;  // 0: saturated
  int8_t sign;
  bool is_nested;
  bool is_inside;  // if it is saturated

  // Whether the first `number` fields, which are all, are lines.
  __attribute__((always_inline)) bool has_lines(
      uint32_t number) const noexcept {
    uintptr_t arcs = arc_bit(field[0]);
    if (number > 1) {
      arcs |= arc_bit(field[1]);
    }
    if (number > 2) {
      arcs |= arc_bit(field[2]);
    }
    return arcs == 0;
  }
  // Where a point lies that is `number` behind the first one.
  PixelPlace place_of(uint32_t number) const noexcept {
    return {place.x_q8 + (number << 8), place.y_q8};
  }
  // False: it is saturated.
  bool begin(const Leaf& found) noexcept {
    size_log2 = static_cast<uint8_t>(found.size_log2);
    if (__builtin_expect(found.reference >= format::glyph::kFirstNode, 1)) {
      return true;
    }
    count = 0;
    is_inside = found.reference == format::glyph::kInside;
    return false;
  }
  // How the fields that were read are combined; outside, if there is none.
  void set(uint32_t field_count, Csg op) noexcept {
    count = static_cast<uint8_t>(field_count);
    sign = static_cast<int8_t>(-(static_cast<int32_t>(op) & 1));
    is_nested = op >= Csg::intersection_of_union;
    if (__builtin_expect(field_count == 0, 0)) {
      is_inside = false;
    }
  }
  Csg field_operator() const noexcept {
    if (is_nested) {
      return sign == 0 ? Csg::intersection_of_union
                       : Csg::union_of_intersection;
    }
    return sign == 0 ? Csg::intersection : Csg::union_;
  }
};

}  // namespace detail
}  // namespace inkcell
