// Primitives combined: intersection is the minimum of their distances, union
// the maximum, and at convex vertices the distance is that to the vertex.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "cells/leaf.hpp"
#include "distance/primitive.hpp"

namespace inkcell {
namespace detail {

struct Stretching;

// A distance that no rounding leaves alone.
inline constexpr int32_t kNoReach = INT32_MAX;

// A leaf, and the point at which it is evaluated.
struct PlacedLeaf : Leaf {
  PixelPlace place;
};

// Combines the values of a leaf's primitives at a point, all with the leaf's
// sign.
class Csg {
 public:
  // Vertices are rounded where that changes a result between -reach_q22 and
  // reach_q22.
  Csg(const FieldScale& scale, int32_t reach_q22) noexcept
      : scale_(scale), reach_q22_(reach_q22) {}

  const FieldScale& scale() const noexcept { return scale_; }
  int32_t bend_shift() const noexcept { return scale_.bend_shift; }

  // Where edges are stretched differently (stretching.hpp). Null: alike; the
  // other two are not set then.
  const Stretching* stretching() const noexcept { return stretching_; }
  const TextStyle& style() const noexcept { return *style_; }
  int32_t far_q22() const noexcept { return far_q22_; }
  void set_stretching(const Stretching& stretching,
                      const TextStyle& style) noexcept;

  // Clamps rounded distances.
  void clamp_rounded(int32_t least_q22, int32_t greatest_q22) noexcept {
    least_q22_ = least_q22;
    greatest_q22_ = greatest_q22;
  }

  // The minimum of two values. `place()` is the point; it is called only near a
  // vertex, and leaf.place is set then.
  template <typename Place>
  __attribute__((always_inline)) int32_t min_of_two(
      PlacedLeaf& leaf,
      int32_t a,
      int32_t b,
      const Place& place) const noexcept {
    const int32_t least = min(a, b);
    if (!is_near_vertex(least, max(a, b))) {
      return least;
    }
    leaf.place = place();
    return rounded_two(leaf, a, b);
  }
  // The minimum of three values, or of the first and the maximum of the others.
  template <typename Place>
  __attribute__((always_inline)) int32_t min_of_three(
      PlacedLeaf& leaf, int32_t a, int32_t b, int32_t c, const Place& place)
      const noexcept {
    const int32_t low = min(b, c);
    const int32_t high = max(b, c);
    bool is_near = false;
    int32_t other = low;
    if (leaf.is_nested) {
      is_near = high > 0 && high < reach_q22_ && low > -high;
      other = high;
    }
    const bool is_first = a <= other;
    const int32_t least = is_first ? a : other;
    const int32_t second = is_first ? other : min(a, high);
    if (!is_near && !is_near_vertex(least, second)) {
      return least;
    }
    leaf.place = place();
    return rounded_three(leaf, a, b, c);
  }

  // The distance, given the values at a point. [px]
  int32_t combine(PlacedLeaf& leaf,
                  const int32_t* values,
                  const PixelPlace& at) const noexcept;

  // The gradient of the distance at leaf.place, given the values there, of unit
  // length.
  Gradient gradient(const PlacedLeaf& leaf,
                    const int32_t* values) const noexcept;

 private:
  // A vector: Arm returns structures of two words in memory, these in
  // registers.
  using TwoWords = uint64_t;
  static Vector vector_of(TwoWords words) noexcept {
    return {wrapped(static_cast<uint32_t>(words)),
            wrapped(static_cast<uint32_t>(words >> 32))};
  }
  // Two of a leaf's primitives, in one word: few fit into registers.
  using Pair = uint32_t;
  static constexpr Pair pair_of(uint32_t a, uint32_t b) noexcept {
    return a << 2 | b;
  }
  // The two values that are left when all but the last step is done.
  struct LastTwo {
    int32_t a;
    int32_t b;
    Pair pair;
  };

  // A vertex is not near where the greater value is farther from 0.
  __attribute__((always_inline)) bool is_near_vertex(
      int32_t least, int32_t other) const noexcept {
    return least < 0 && least > -reach_q22_ && other < -least;
  }
  int32_t clamped(int32_t value, int32_t sign) const noexcept {
    return with_sign(
        min(max(with_sign(value, sign), least_q22_), greatest_q22_), sign);
  }
  TwoWords gradient_of(const PlacedLeaf& leaf, uint32_t number) const noexcept;
  int32_t rounded(const PlacedLeaf& leaf,
                  int32_t a,
                  int32_t b,
                  Pair pair) const noexcept;
  int32_t rounded_two(const PlacedLeaf& leaf,
                      int32_t a,
                      int32_t b) const noexcept;
  LastTwo last_two(const PlacedLeaf& leaf,
                   int32_t a,
                   int32_t b,
                   int32_t c) const noexcept;
  int32_t rounded_three(const PlacedLeaf& leaf,
                        int32_t a,
                        int32_t b,
                        int32_t c) const noexcept;

 protected:
  FieldScale scale_;
  int32_t reach_q22_;

 private:
  int32_t least_q22_ = INT32_MIN;
  int32_t greatest_q22_ = INT32_MAX;
  int32_t far_q22_;
  const Stretching* stretching_ = nullptr;
  const TextStyle* style_;
};

}  // namespace detail
}  // namespace inkcell
