// Finding leaves of cells of fields, and rounding their vertices.
#include "field_leaves.hpp"

namespace inkcell {
namespace detail {

__attribute__((noinline)) void FieldLeaves::find_narrow(
    uint32_t x, uint32_t y, FieldLeaf& leaf) const noexcept {
  using format::fields::kArcBytes;
  using format::fields::kLineBytes;
  const Leaf found = find_narrow_leaf(field_, tile_of(x, y), x, y);
  if (!leaf.begin(found)) {
    return;
  }
  const uint8_t* const cells = field_.cells;
  const uint32_t arcs = field_.arc_count;
  const uint8_t* const lines = cells + (kArcBytes - kLineBytes) * arcs;
  FieldOperator op = FieldOperator::least;
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
  FieldOperator op = FieldOperator::least;
  const uint32_t count = heap.read_leaf(
      found.reference,
      [=](uint32_t unit) {
        return cells + 2 * (unit & linked::kOffsetMask) + (unit >> 15);
      },
      leaf.field, op);
  leaf.set(count, op);
}

// Without the leaf's sign. [Q14]
__attribute__((noinline)) Vector FieldLeaves::gradient(
    const uint8_t* field, const PixelPlace& at) const noexcept {
  if (arc_bit(field) == 0) {
    return normal_of(field);
  }
  const ArcTerm term(field, at, scale_, 0);
  return bent(normal_of(field - 1), term.slope_q15(bend_shift()));
}

// The lesser of two values, rounded.
__attribute__((noinline)) int32_t FieldLeaves::rounded(
    int32_t a,
    const uint8_t* a_field,
    int32_t b,
    const uint8_t* b_field,
    const PixelPlace& at) const noexcept {
  if (a > b) {
    const int32_t value = a;
    a = b;
    b = value;
    const uint8_t* field = a_field;
    a_field = b_field;
    b_field = field;
  }
  if (!is_near_vertex(a, b)) {
    return a;
  }
  return rounded_q22(a, gradient(a_field, at), b, gradient(b_field, at));
}

__attribute__((noinline)) int32_t FieldLeaves::rounded_two(
    const FieldLeaf& leaf,
    int32_t a,
    int32_t b,
    uint32_t number) const noexcept {
  return limited(
      rounded(a, leaf.field[0], b, leaf.field[1], leaf.place_of(number)),
      leaf.sign);
}

__attribute__((noinline)) int32_t FieldLeaves::rounded_three(
    const FieldLeaf& leaf,
    int32_t a,
    int32_t b,
    int32_t c,
    uint32_t number) const noexcept {
  const PixelPlace at = leaf.place_of(number);
  uint32_t first = 0;
  uint32_t second = 1;
  if (leaf.is_nested) {
    // The greater one is the lesser with the signs turned.
    second = b >= c ? 1 : 2;
    b = with_sign(rounded(with_sign(b, -1), leaf.field[1], with_sign(c, -1),
                          leaf.field[2], at),
                  -1);
  } else if (a > b && a > c) {
    first = 2;  // without the greatest
    a = c;
  } else if (b > c) {
    second = 2;
    b = c;
  }
  return limited(rounded(a, leaf.field[first], b, leaf.field[second], at),
                 leaf.sign);
}

}  // namespace detail
}  // namespace inkcell
