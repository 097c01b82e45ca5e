#include "field_row.hpp"

namespace inkcell {
namespace detail {

class FieldRow::PlainValues {
 public:
  explicit PlainValues(const FieldRow& row) noexcept : row_(row) {}

  static void set_up(uint32_t) noexcept {}

  static int32_t* side(int32_t value, int32_t* out) noexcept {
    *out = value;
    return out + 1;
  }

  int32_t* one(uint32_t x_q8, int32_t* out) const noexcept {
    return side(value(0, x_q8), out);
  }

  int32_t* two(uint32_t x_q8, int32_t* out) const noexcept {
    const int32_t sign = fields.sign;
    const int32_t a = with_sign(value(0, x_q8), sign);
    int32_t least = a;
    if (a > -row_.reach_q22_) {
      const int32_t b = with_sign(value(1, x_q8), sign);
      const bool in_order = a <= b;
      least = in_order ? a : b;
      if (row_.is_near_vertex(least, in_order ? b : a)) {
        least = row_.rounded_two(fields, a, b, x_q8);
      }
    }
    return side(with_sign(least, sign), out);
  }

  int32_t* three(uint32_t x_q8, int32_t* out) const noexcept {
    const int32_t sign = fields.sign;
    const int32_t a = with_sign(value(0, x_q8), sign);
    int32_t least = a;
    if (a > -row_.reach_q22_) {
      const int32_t b = with_sign(value(1, x_q8), sign);
      const int32_t c = with_sign(value(2, x_q8), sign);
      least = row_.least_of_three(fields, a, b, c, x_q8);
    }
    return side(with_sign(least, sign), out);
  }

  Fields fields;

 private:
  int32_t value(uint32_t i, uint32_t x_q8) const noexcept {
    return row_.value(fields.place[i], x_q8);
  }

  const FieldRow& row_;
};

void FieldRow::take(RowPoint at, int32_t* out, int32_t count) const noexcept {
  take_with<PlainValues>(at, out, count);
}

__attribute__((noinline)) uint32_t FieldRow::read_linked(
    uint32_t reference, Fields& fields) const noexcept {
  FieldOperator op = FieldOperator::least;
  const uint32_t count = LinkedHeap(field_).read_leaf(
      reference,
      [](uint32_t unit) {
        return 2 * (unit & format::linked::kOffsetMask) + (unit >> 15);
      },
      fields.place, op);
  fields.set(op);
  return count;
}

__attribute__((noinline)) Vector FieldRow::gradient(
    uint32_t place, uint32_t x_q8) const noexcept {
  return gradient_q14(field_, place >> 1 | (place & 1) << 15, x_q8, y_q8_,
                      scale_);
}

// The lesser of two values, rounded.
__attribute__((noinline)) int32_t FieldRow::rounded(
    int32_t a,
    uint32_t a_place,
    int32_t b,
    uint32_t b_place,
    uint32_t x_q8) const noexcept {
  if (a > b) {
    const int32_t value = a;
    a = b;
    b = value;
    const uint32_t place = a_place;
    a_place = b_place;
    b_place = place;
  }
  if (!is_near_vertex(a, b)) {
    return a;
  }
  return rounded_q22(a, gradient(a_place, x_q8), b, gradient(b_place, x_q8));
}

// The last step is a call in place of this one: its frame is the smaller.
__attribute__((noinline)) int32_t FieldRow::rounded_three(
    const Fields& fields,
    int32_t a,
    int32_t b,
    int32_t c,
    uint32_t x_q8) const noexcept {
  uint32_t first = 0;
  uint32_t second = 1;
  if (fields.is_nested) {
    // The greater one is the lesser with the signs turned.
    second = b >= c ? 1 : 2;
    b = with_sign(rounded(with_sign(b, -1), fields.place[1], with_sign(c, -1),
                          fields.place[2], x_q8),
                  -1);
  } else if (a > b && a > c) {
    first = 2;  // without the greatest
    a = c;
  } else if (b > c) {
    second = 2;
    b = c;
  }
  return rounded(a, fields.place[first], b, fields.place[second], x_q8);
}

}  // namespace detail
}  // namespace inkcell
