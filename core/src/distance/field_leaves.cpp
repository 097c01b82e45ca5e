// Finding leaves of cells of primitives, and rounding their vertices.
#include "distance/field_leaves.hpp"

namespace inkcell {
namespace detail {

__attribute__((noinline)) void FieldLeaves::find_leaf(
    uint32_t x, uint32_t y, FieldLeaf& leaf) const noexcept {
  if (__builtin_expect(field_.kind != GlyphField::Kind::narrow_fields, 0)) {
    find_linked(x, y, leaf);
    return;
  }
  using format::edges::kArcBytes;
  using format::edges::kLineBytes;
  const Leaf found = find_narrow_leaf(field_, tile_of(x, y), x, y);
  if (!leaf.begin(found)) {
    return;
  }
  const uint8_t* const cells = field_.cells;
  const uint32_t arcs = field_.arc_count;
  const uint8_t* const lines = cells + (kArcBytes - kLineBytes) * arcs;
  Csg op = Csg::intersection;
  const uint32_t count = read_narrow_leaf(
      field_, found.reference,
      [=](uint32_t number) {
        return number < arcs ? cells + kArcBytes * number + 1
                             : lines + kLineBytes * number;
      },
      leaf.field, op);
  leaf.set(count, op);
}

__attribute__((noinline)) void FieldLeaves::find_linked(
    uint32_t x, uint32_t y, FieldLeaf& leaf) const noexcept {
  namespace linked = format::linked;
  const LinkedHeap heap(field_);
  const Leaf found = heap.find_leaf(tile_of(x, y), field_.tile_log2, x, y);
  if (!leaf.begin(found)) {
    return;
  }
  const uint8_t* const cells = field_.cells;
  Csg op = Csg::intersection;
  const uint32_t count = heap.read_leaf(
      found.reference,
      [=](uint32_t unit) {
        return cells + 2 * (unit & linked::kOffsetMask) + (unit >> 15);
      },
      leaf.field, op);
  leaf.set(count, op);
}

// Without the leaf's sign. [Q14]
__attribute__((noinline)) FieldLeaves::TwoWords FieldLeaves::gradient(
    const uint8_t* field, const PixelPlace& at) const noexcept {
  Vector gradient = normal_of(field - arc_bit(field));
  if (arc_bit(field) != 0) {
    const ArcTerm term(field, at, scale_, 0);
    gradient = bent(gradient, term.slope_q15(bend_shift()));
  }
  return static_cast<uint32_t>(gradient.x) |
         TwoWords{static_cast<uint32_t>(gradient.y)} << 32;
}

// The lesser of the values of two fields that are near their vertex, rounded.
__attribute__((noinline)) int32_t FieldLeaves::rounded(
    const FieldLeaf& leaf,
    int32_t least,
    int32_t other,
    Pair pair,
    uint32_t number) const noexcept {
  const PixelPlace at = leaf.place_of(number);
  const TwoWords g = gradient(leaf.field[pair >> 2], at);
  const TwoWords h = gradient(leaf.field[pair & 3], at);
  return rounded_q22(least, other, cosine_q14(vector_of(g), vector_of(h)));
}

__attribute__((noinline)) int32_t FieldLeaves::rounded_two(
    const FieldLeaf& leaf,
    int32_t a,
    int32_t b,
    uint32_t number) const noexcept {
  return limited(rounded(leaf, min(a, b), max(a, b), pair_of(0, 1), number),
                 leaf.sign);
}

__attribute__((noinline)) int32_t FieldLeaves::rounded_three(
    const FieldLeaf& leaf,
    int32_t a,
    int32_t b,
    int32_t c,
    uint32_t number) const noexcept {
  uint32_t first = 0;
  uint32_t second = 1;
  if (leaf.is_nested) {
    // The greater one is the lesser with the signs turned.
    second = b >= c ? 1 : 2;
    b = with_sign(b, -1);
    c = with_sign(c, -1);
    const int32_t least = min(b, c);
    const int32_t other = max(b, c);
    b = with_sign(is_near_vertex(least, other)
                      ? rounded(leaf, least, other, pair_of(1, 2), number)
                      : least,
                  -1);
  } else if (a > b && a > c) {
    first = 2;  // without the greatest
    a = c;
  } else if (b > c) {
    second = 2;
    b = c;
  }
  int32_t least = min(a, b);
  const int32_t other = max(a, b);
  if (is_near_vertex(least, other)) {
    least = rounded(leaf, least, other, pair_of(first, second), number);
  }
  return limited(least, leaf.sign);
}

}  // namespace detail
}  // namespace inkcell
