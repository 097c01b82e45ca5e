#include "field_row.hpp"

namespace inkcell {
namespace detail {

// Each value in one step, from the record.
class FieldRow::PlainValues {
 public:
  explicit PlainValues(const FieldRow& row) noexcept : row_(row) {}

  void begin(uint32_t, uint32_t) noexcept {}

  int32_t far_q22() const noexcept { return row_.reach_q22_; }

  template <typename Distance>
  int32_t* put(uint32_t x_q8,
               int32_t* out,
               const Distance& distance) const noexcept {
    *out = distance(x_q8);
    return out + 1;
  }

  // FieldTerm::value_q22. [px]
  int32_t distance(uint32_t i, uint32_t x_q8) const noexcept {
    namespace layout = format::fields;
    const uint32_t place = fields.place[i];
    const uint8_t* const at = row_.cells_ + (place & ~uint32_t{1});
    const int32_t nx = load_i16(at + layout::kNormalX);
    const int32_t ny = load_i16(at + layout::kNormalY);
    const FieldScale& scale = row_.scale_;
    uint32_t value = times(nx, x_q8) + times(ny, row_.y_q8_) +
                     times(load_i16(at + layout::kOffset), scale.size_q8);
    if ((place & 1) != 0) {
      const auto along = static_cast<uint32_t>(
          wrapped(times(nx, row_.y_q8_) - times(ny, x_q8) + (1 << 13) +
                  times(load_i16(at + layout::kAlong), scale.size_q8)) >>
          14);
      const int32_t bend =
          (load_i16(at + layout::kBend) * scale.bend_q14 + (1 << 10)) >> 11;
      const auto slope = static_cast<uint32_t>(wrapped(times(bend, along)) >>
                                               row_.bend_shift_);
      value += static_cast<uint32_t>(wrapped(slope * along) >> 1);
    }
    return wrapped(value);
  }

  Fields fields;

 private:
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

__attribute__((noinline)) void FieldRow::set_up(
    uint32_t place, uint32_t x_q8, FieldTerm& term) const noexcept {
  set_up_term(term, field_, place >> 1 | (place & 1) << 15, x_q8, y_q8_,
              scale_);
}

// The lesser of two values, rounded.
__attribute__((noinline)) int32_t FieldRow::rounded(
    const Operand& a, const Operand& b, uint32_t x_q8) const noexcept {
  const bool in_order = a.value_q22 <= b.value_q22;
  const Operand& lesser = in_order ? a : b;
  const Operand& greater = in_order ? b : a;
  if (!is_near_vertex(lesser.value_q22, greater.value_q22)) {
    return lesser.value_q22;
  }
  FieldTerm lesser_term;
  FieldTerm greater_term;
  set_up(lesser.place, x_q8, lesser_term);
  set_up(greater.place, x_q8, greater_term);
  return rounded_q22(lesser.value_q22, lesser_term, greater.value_q22,
                     greater_term, scale_.bend_log2);
}

__attribute__((noinline)) int32_t FieldRow::rounded_two(
    const Fields& fields, int32_t a, int32_t b, uint32_t x_q8) const noexcept {
  return rounded({a, fields.place[0]}, {b, fields.place[1]}, x_q8);
}

__attribute__((noinline)) int32_t FieldRow::rounded_three(
    const Fields& fields,
    int32_t a,
    int32_t b,
    int32_t c,
    uint32_t x_q8) const noexcept {
  Operand first = {a, fields.place[0]};
  Operand second = {b, fields.place[1]};
  if (fields.is_nested) {
    // The greater one is the lesser with the signs turned.
    const int32_t inner =
        with_sign(rounded({with_sign(b, -1), fields.place[1]},
                          {with_sign(c, -1), fields.place[2]}, x_q8),
                  -1);
    second = {inner, fields.place[b >= c ? 1 : 2]};
  } else if (a > b && a > c) {
    first = {c, fields.place[2]};  // without the greatest
  } else if (b > c) {
    second = {c, fields.place[2]};
  }
  return rounded(first, second, x_q8);
}

}  // namespace detail
}  // namespace inkcell
