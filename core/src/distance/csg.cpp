#include "distance/csg.hpp"

#include "distance/stretching.hpp"
#include "distance/vertex.hpp"

namespace inkcell {
namespace detail {
namespace {

Gradient unit_vector(Vector v) noexcept {
  constexpr int32_t kOneQ14 = 1 << 14;
  while (v.x >= kOneQ14 || v.x < -kOneQ14 || v.y >= kOneQ14 || v.y < -kOneQ14) {
    v.x >>= 1;
    v.y >>= 1;
  }
  const uint32_t length = root(static_cast<uint32_t>(v.x * v.x + v.y * v.y));
  Gradient result;
  if (length != 0) {
    const auto part = [length](int32_t x) noexcept {
      const auto size = static_cast<uint32_t>(abs(x));
      const auto q14 = static_cast<int32_t>((size << 14) / length);
      return static_cast<int16_t>(x < 0 ? -q14 : q14);
    };
    result.x.raw = part(v.x);
    result.y.raw = part(v.y);
  }
  return result;
}

}  // namespace

void Csg::set_stretching(const Stretching& stretching,
                         const TextStyle& style) noexcept {
  stretching_ = &stretching;
  style_ = &style;
  far_q22_ = stretching.far_q22(style, reach_q22_);
}

// The gradient of a primitive, without the leaf's sign. [Q14]
__attribute__((noinline)) Csg::TwoWords Csg::gradient_of(
    const PlacedLeaf& leaf, uint32_t number) const noexcept {
  const PrimitiveRef primitive = leaf.parts[number];
  Vector gradient = normal_of(record_of(primitive));
  if (arc_bit(primitive) != 0) {
    gradient =
        ArcValue(primitive, scale_, 0).gradient_q14(leaf.place, bend_shift());
  }
  if (stretching_ != nullptr) {
    gradient = stretching_->on_screen(*this, gradient);
  }
  return static_cast<uint32_t>(gradient.x) |
         TwoWords{static_cast<uint32_t>(gradient.y)} << 32;
}

// The minimum of the values of two primitives near their vertex. Their order
// does not matter, though the roundings in a cone are not symmetric: records
// may name a pair's primitives in either.
__attribute__((noinline)) int32_t Csg::rounded(const PlacedLeaf& leaf,
                                               int32_t a,
                                               int32_t b,
                                               Pair pair) const noexcept {
  const TwoWords g = gradient_of(leaf, pair >> 2);
  const TwoWords h = gradient_of(leaf, pair & 3);
  return rounded_q22(min(a, b), max(a, b),
                     cosine_q14(vector_of(g), vector_of(h)));
}

__attribute__((noinline)) int32_t Csg::rounded_two(const PlacedLeaf& leaf,
                                                   int32_t a,
                                                   int32_t b) const noexcept {
  return clamped(rounded(leaf, a, b, pair_of(0, 1)), leaf.sign);
}

__attribute__((always_inline)) inline Csg::LastTwo Csg::last_two(
    const PlacedLeaf& leaf, int32_t a, int32_t b, int32_t c) const noexcept {
  if (leaf.is_nested) {
    // The maximum is the minimum with the signs turned.
    const Pair pair = pair_of(0, b >= c ? 1 : 2);
    b = with_sign(b, -1);
    c = with_sign(c, -1);
    int32_t least = min(b, c);
    if (is_near_vertex(least, max(b, c))) {
      least = rounded(leaf, b, c, pair_of(1, 2));
    }
    return {a, with_sign(least, -1), pair};
  }
  // Without the greatest.
  if (a > b && a > c) {
    return {b, c, pair_of(1, 2)};
  }
  return b > c ? LastTwo{a, c, pair_of(0, 2)} : LastTwo{a, b, pair_of(0, 1)};
}

__attribute__((noinline)) int32_t Csg::rounded_three(const PlacedLeaf& leaf,
                                                     int32_t a,
                                                     int32_t b,
                                                     int32_t c) const noexcept {
  const LastTwo two = last_two(leaf, a, b, c);
  int32_t least = min(two.a, two.b);
  if (is_near_vertex(least, max(two.a, two.b))) {
    least = rounded(leaf, two.a, two.b, two.pair);
  }
  return clamped(least, leaf.sign);
}

int32_t Csg::combine(PlacedLeaf& leaf,
                     const int32_t* values,
                     const PixelPlace& at) const noexcept {
  const auto place = [&at]() noexcept { return at; };
  int32_t least = values[0];
  if (leaf.count == 2) {
    least = min_of_two(leaf, values[0], values[1], place);
  } else if (leaf.count == 3) {
    least = min_of_three(leaf, values[0], values[1], values[2], place);
  }
  return with_sign(least, leaf.sign);
}

Gradient Csg::gradient(const PlacedLeaf& leaf,
                       const int32_t* values) const noexcept {
  if (leaf.count == 1) {
    return unit_vector(vector_of(gradient_of(leaf, 0)));
  }
  const LastTwo two = leaf.count == 2
                          ? LastTwo{values[0], values[1], pair_of(0, 1)}
                          : last_two(leaf, values[0], values[1], values[2]);
  const Vector g = vector_of(gradient_of(leaf, two.pair >> 2));
  const Vector h = vector_of(gradient_of(leaf, two.pair & 3));
  Cone cone;
  if (is_near_vertex(min(two.a, two.b), max(two.a, two.b)) &&
      find_cone(two.a, two.b, cosine_q14(g, h), cone)) {
    const int32_t a = -cone.a_bc_q14 >> 15;
    const int32_t b = -cone.b_ac_q14 >> 15;
    return unit_vector({a * g.x + b * h.x, a * g.y + b * h.y});
  }
  if (two.a < two.b) {
    return unit_vector(g);
  }
  if (leaf.count == 3 && leaf.is_nested) {
    PlacedLeaf inner = leaf;
    inner.count = 2;
    inner.parts[0] = leaf.parts[1];
    inner.parts[1] = leaf.parts[2];
    const int32_t turned[] = {with_sign(values[1], -1),
                              with_sign(values[2], -1)};
    return gradient(inner, turned);  // which is of two: it ends here
  }
  return unit_vector(h);
}

}  // namespace detail
}  // namespace inkcell
