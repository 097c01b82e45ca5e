// Leaves of cells of fields along a row, and what they cover.
#include "field_row.hpp"

namespace inkcell {
namespace detail {

__attribute__((noinline)) void FieldRow::find_narrow(
    uint32_t x, RowLeaf& leaf) const noexcept {
  using format::fields::kArcBytes;
  using format::fields::kLineBytes;
  const Leaf found = find_narrow_leaf(field_, tile_of(x), x, y_u_);
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

__attribute__((noinline)) void FieldRow::find_linked(
    uint32_t x, RowLeaf& leaf) const noexcept {
  namespace linked = format::linked;
  const LinkedHeap heap(field_);
  const Leaf found = heap.find_leaf(tile_of(x), field_.tile_log2, x, y_u_);
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

bool FieldRow::cover(RowPoint at,
                     const CoverageRamp& ramp,
                     uint8_t* const first,
                     int32_t count) const noexcept {
  const uint32_t step = step_q16_;
  const auto first_q8 = static_cast<uint32_t>(wrapped(at.x_q20) >> 12);
  uint32_t x_q16 = at.x_q16;
  uint8_t* out = first;
  const uint32_t end_q16 = x_q16 + static_cast<uint32_t>(count) * step;
  bool any = false;
  while (x_q16 < end_q16) {
    RowLeaf leaf;
    find_leaf(x_q16, leaf);
    const uint32_t stop_q16 = stop_of(leaf, x_q16, end_q16);
    const uint32_t fields = leaf.count;
    if (fields == 0) {
      any |= leaf.is_inside;
      const uint8_t side = leaf.is_inside ? 255 : 0;
      do {
        *out++ = side;
        x_q16 += step;
      } while (x_q16 < stop_q16);
      continue;
    }
    any = true;
    const auto x_q8 = [=](uint8_t * here) __attribute__((always_inline)) {
      return first_q8 + (static_cast<uint32_t>(here - first) << 8);
    };
    const PixelPlace place = {x_q8(out), y_q8_};
    const int32_t sign = leaf.sign;
    // True if the leaf ends there.
    const auto put = [&](int32_t value) __attribute__((always_inline)) {
      *out++ = ramp(with_sign(value, sign));
      x_q16 += step;
      return x_q16 >= stop_q16;
    };
    const auto any_number = [&](uint32_t number) {
      ArcTerm terms[3];
      for (uint32_t i = 0; i < number; ++i) {
        terms[i] = ArcTerm(leaf.field[i], place, scale_, sign);
      }
      int32_t least;
      do {
        int32_t values[3];
        for (uint32_t i = 0; i < number; ++i) {
          values[i] = terms[i].value(bend_shift_, sign);
          terms[i].go_on();
        }
        least = values[0];
        if (number == 2) {
          least = least_of_two(leaf, values[0], values[1], x_q8(out));
        } else if (number == 3) {
          least =
              least_of_three(leaf, values[0], values[1], values[2], x_q8(out));
        }
      } while (!put(least));
    };
    const auto one = [&](auto a) __attribute__((always_inline)) {
      while (true) {
        *out++ = ramp(a.value(bend_shift_, 0));
        x_q16 += step;
        if (x_q16 >= stop_q16) {
          return;
        }
        a.go_on();
      }
    };
    const auto two = [&](auto a, auto b) __attribute__((always_inline)) {
      while (!put(least_of_two(leaf, a.value(bend_shift_, sign),
                               b.value(bend_shift_, sign), x_q8(out)))) {
        a.go_on();
        b.go_on();
      }
    };
    const auto three = [&](auto a, auto b, auto c)
        __attribute__((always_inline)) {
      while (!put(least_of_three(leaf, a.value(bend_shift_, sign),
                                 b.value(bend_shift_, sign),
                                 c.value(bend_shift_, sign), x_q8(out)))) {
        a.go_on();
        b.go_on();
        c.go_on();
      }
    };
    if (!kFastRows) {
      any_number(fields);
      continue;
    }
    const uint8_t* const f0 = leaf.field[0];
    const uint8_t* const f1 = leaf.field[1];
    const uint8_t* const f2 = leaf.field[2];
    if (fields == 1) {
      if (arc_bit(f0) == 0) {
        one(LineTerm(f0, place, scale_, 0));
      } else {
        one(ArcTerm(f0, place, scale_, 0));
      }
    } else if (fields == 2) {
      if ((arc_bit(f0) | arc_bit(f1)) == 0) {
        two(LineTerm(f0, place, scale_, sign),
            LineTerm(f1, place, scale_, sign));
      } else {
        two(ArcTerm(f0, place, scale_, sign), ArcTerm(f1, place, scale_, sign));
      }
    } else if (leaf.has_lines()) {
      three(LineTerm(f0, place, scale_, sign),
            LineTerm(f1, place, scale_, sign),
            LineTerm(f2, place, scale_, sign));
    } else {
      three(ArcTerm(f0, place, scale_, sign), ArcTerm(f1, place, scale_, sign),
            ArcTerm(f2, place, scale_, sign));
    }
  }
  return any;
}

__attribute__((noinline)) Vector FieldRow::gradient(
    const uint8_t* field, uint32_t x_q8) const noexcept {
  const auto place = static_cast<uint32_t>(field - field_.cells);
  return gradient_q14(field_, place >> 1 | (place & 1) << 15, x_q8, y_q8_,
                      scale_);
}

// The lesser of two values, rounded.
__attribute__((noinline)) int32_t FieldRow::rounded(
    int32_t a,
    const uint8_t* a_field,
    int32_t b,
    const uint8_t* b_field,
    uint32_t x_q8) const noexcept {
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
  return rounded_q22(a, gradient(a_field, x_q8), b, gradient(b_field, x_q8));
}

// The last step is a call in place of this one: its frame is the smaller.
__attribute__((noinline)) int32_t FieldRow::rounded_three(
    const RowLeaf& leaf,
    int32_t a,
    int32_t b,
    int32_t c,
    uint32_t x_q8) const noexcept {
  uint32_t first = 0;
  uint32_t second = 1;
  if (leaf.is_nested) {
    // The greater one is the lesser with the signs turned.
    second = b >= c ? 1 : 2;
    b = with_sign(rounded(with_sign(b, -1), leaf.field[1], with_sign(c, -1),
                          leaf.field[2], x_q8),
                  -1);
  } else if (a > b && a > c) {
    first = 2;  // without the greatest
    a = c;
  } else if (b > c) {
    second = 2;
    b = c;
  }
  return rounded(a, leaf.field[first], b, leaf.field[second], x_q8);
}

}  // namespace detail
}  // namespace inkcell
