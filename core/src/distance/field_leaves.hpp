// Leaves of cells of primitives, as rows and bands of points meet them.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "cells/field_cell.hpp"
#include "distance/field_leaf.hpp"
#include "distance/row_terms.hpp"
#include "inkcell/field.hpp"
#include "raster/field_draw.hpp"

namespace inkcell {
namespace detail {

// A point's number in its row, for FieldLeaves::least_of_two.
struct RowNumber {
  uint32_t number;

  __attribute__((always_inline)) uint32_t operator()() const noexcept {
    return number;
  }
};

// Bands cut rounded values off at these, which are distances: values have the
// leaf's sign.
template <bool kHasBands>
class RoundedLimits {
 protected:
  // From here on; before, nothing is cut off.
  void limit_rounded(int32_t least_q22, int32_t greatest_q22) noexcept {
    least_q22_ = least_q22;
    greatest_q22_ = greatest_q22;
  }
  int32_t limited(int32_t value, int32_t sign) const noexcept {
    return with_sign(
        min(max(with_sign(value, sign), least_q22_), greatest_q22_), sign);
  }

 private:
  int32_t least_q22_ = INT32_MIN;
  int32_t greatest_q22_ = INT32_MAX;
};

template <>
class RoundedLimits<false> {
 protected:
  static void limit_rounded(int32_t, int32_t) noexcept {}
  static int32_t limited(int32_t value, int32_t) noexcept { return value; }
};

// Finds leaves, and combines what their fields say at a point.
class FieldLeaves : protected RoundedLimits<kObjectOrder> {
 public:
  FieldLeaves(const GlyphField& field,
              const FieldScale& scale,
              int32_t reach_q22) noexcept
      : scale_(scale), reach_q22_(reach_q22), field_(field) {}

  const FieldScale& scale() const noexcept { return scale_; }
  int32_t bend_shift() const noexcept { return scale_.bend_shift; }

  // The least of a leaf's values at a point, with the leaf's sign, or what is
  // left of three if they are nested. `number()` says how many points behind
  // leaf.place it lies; it is called only where it matters.
  template <typename Number>
  int32_t least_of_two(const FieldLeaf& leaf,
                       int32_t a,
                       int32_t b,
                       const Number& number) const noexcept;
  template <typename Number>
  int32_t least_of_three(const FieldLeaf& leaf,
                         int32_t a,
                         int32_t b,
                         int32_t c,
                         const Number& number) const noexcept;

 protected:
  // The leaf that holds a point, from the grid's corner. [u]
  void find_leaf(uint32_t x, uint32_t y, FieldLeaf& leaf) const noexcept;

  FieldScale scale_;
  int32_t reach_q22_;
  const GlyphField& field_;

 private:
  void find_linked(uint32_t x, uint32_t y, FieldLeaf& leaf) const noexcept;
  uint32_t tile_of(uint32_t x, uint32_t y) const noexcept {
    return (y >> field_.tile_log2) * uint32_t{field_.tiles_x} +
           (x >> field_.tile_log2);
  }
  // A vector: Arm returns structures of two words in memory, these in
  // registers.
  using TwoWords = uint64_t;
  static Vector vector_of(TwoWords words) noexcept {
    return {wrapped(static_cast<uint32_t>(words)),
            wrapped(static_cast<uint32_t>(words >> 32))};
  }
  TwoWords gradient(const uint8_t* field, const PixelPlace& at) const noexcept;
  // Two of a leaf's fields, in one word: few fit into registers.
  using Pair = uint32_t;
  static constexpr Pair pair_of(uint32_t a, uint32_t b) noexcept {
    return a << 2 | b;
  }
  int32_t rounded(const FieldLeaf& leaf,
                  int32_t least,
                  int32_t other,
                  Pair pair,
                  uint32_t number) const noexcept;
  int32_t rounded_two(const FieldLeaf& leaf,
                      int32_t a,
                      int32_t b,
                      uint32_t number) const noexcept;
  int32_t rounded_three(const FieldLeaf& leaf,
                        int32_t a,
                        int32_t b,
                        int32_t c,
                        uint32_t number) const noexcept;
  bool is_near_vertex(int32_t lesser, int32_t greater) const noexcept {
    // Where the greater one is farther from 0 no vertex is near.
    return lesser < 0 && lesser > -reach_q22_ && lesser + greater < 0;
  }
};

template <typename Number>
__attribute__((always_inline)) inline int32_t FieldLeaves::least_of_two(
    const FieldLeaf& leaf,
    int32_t a,
    int32_t b,
    const Number& number) const noexcept {
  const int32_t least = min(a, b);
  return least < 0 && least > -reach_q22_ && a + b < 0
             ? rounded_two(leaf, a, b, number())
             : least;
}

template <typename Number>
__attribute__((always_inline)) inline int32_t FieldLeaves::least_of_three(
    const FieldLeaf& leaf,
    int32_t a,
    int32_t b,
    int32_t c,
    const Number& number) const noexcept {
  const int32_t low = min(b, c);
  const int32_t high = max(b, c);
  bool is_near = false;
  int32_t other = low;
  if (leaf.is_nested) {
    is_near = high > 0 && high < reach_q22_ && low + high > 0;
    other = high;
  }
  const bool is_first = a <= other;
  const int32_t least = is_first ? a : other;
  const int32_t second = is_first ? other : min(a, high);
  return is_near || is_near_vertex(least, second)
             ? rounded_three(leaf, a, b, c, number())
             : least;
}

}  // namespace detail
}  // namespace inkcell
