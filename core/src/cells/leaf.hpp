// A leaf of a glyph's quadtree: what its record says of it.
#pragma once

#include <stdint.h>

#include "inkcell/format/cell.hpp"

namespace inkcell {
namespace detail {

inline constexpr bool kHasPrimitives = INKCELL_EDGE_CELLS != 0;

// Where the record of a primitive lies, plus 1 if it is an arc.
using PrimitiveRef = const uint8_t*;

inline uintptr_t arc_bit(PrimitiveRef primitive) noexcept {
  return reinterpret_cast<uintptr_t>(primitive) & 1;
}
inline const uint8_t* record_of(PrimitiveRef primitive) noexcept {
  return primitive - arc_bit(primitive);
}

// Values with `sign` -1 are negated, so that only minima remain.
struct Leaf {
  // Leaves the members uninitialised; the reader fills them. User-provided, so
  // that derived leaves may reuse the padding at its end.
  Leaf() noexcept {}

  // One to three primitives; or nine samples in the first place.
  PrimitiveRef parts[3];
  uint8_t count;  // of primitives; kSamples; 0: saturated
  int8_t sign;
  bool is_nested;  // min(f0, max(f1, f2)) of the values with the sign
  bool is_inside;  // if it is saturated
  uint8_t size_log2;

  static constexpr uint8_t kSamples = 4;

  bool has_samples() const noexcept {
    return INKCELL_SAMPLE_CELLS != 0 && count == kSamples;
  }
  bool has_primitives() const noexcept {
    return kHasPrimitives && count != 0 && !has_samples();
  }
  // Whether the first `number` primitives, which are all, are lines.
  __attribute__((always_inline)) bool has_lines(
      uint32_t number) const noexcept {
    uintptr_t arcs = arc_bit(parts[0]);
    if (number > 1) {
      arcs |= arc_bit(parts[1]);
    }
    if (number > 2) {
      arcs |= arc_bit(parts[2]);
    }
    return arcs == 0;
  }
  void saturate(bool inside) noexcept {
    count = 0;
    is_inside = inside;
  }
  // How `number` primitives are combined; outside, if there is none.
  void combine(uint32_t number, Csg op) noexcept {
    count = static_cast<uint8_t>(number);
    sign = static_cast<int8_t>(-(static_cast<int32_t>(op) & 1));
    is_nested = op >= Csg::intersection_of_union;
    if (__builtin_expect(number == 0, 0)) {
      is_inside = false;
    }
  }
  Csg field_operator() const noexcept {
    return static_cast<Csg>((is_nested ? 2 : 0) - sign);
  }
};

}  // namespace detail
}  // namespace inkcell
