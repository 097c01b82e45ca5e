// Rows of points in threes.
#include "field_row.hpp"
#include "order.hpp"

namespace inkcell {
namespace detail {

// What a field is at a point, and how much it gains in a third of a pixel.
class FieldRow::ThirdValues {
 public:
  explicit ThirdValues(const FieldRow& row) noexcept : row_(row) {}

  static int32_t* side(int32_t value, int32_t* out) noexcept {
    out[0] = out[1] = out[2] = value;
    return out + 3;
  }

  int32_t* one(uint32_t x_q8, int32_t* out) const noexcept {
    const Point a = at(0, x_q8);
    out[0] = a.before();
    out[1] = a.value_q22;
    out[2] = a.behind();
    return out + 3;
  }

  int32_t* two(uint32_t x_q8, int32_t* out) const noexcept {
    const Point a = at(0, x_q8);
    if (a.value_q22 <= -row_.thirds_reach_q22()) {
      return side(with_sign(a.value_q22, fields.sign), out);
    }
    const Point b = at(1, x_q8);
    const bool in_order = a.value_q22 <= b.value_q22;
    const int32_t least = in_order ? a.value_q22 : b.value_q22;
    if (is_far(least)) {
      return side(with_sign(least, fields.sign), out);
    }
    int32_t change = 0;
    if (row_.is_near_vertex(least, in_order ? b.value_q22 : a.value_q22)) {
      change = row_.rounded_two(fields, a.value_q22, b.value_q22, x_q8) - least;
    }
    return put(lesser(a.before(), b.before()), least,
               lesser(a.behind(), b.behind()), change, out);
  }

  int32_t* three(uint32_t x_q8, int32_t* out) const noexcept {
    const Point a = at(0, x_q8);
    if (a.value_q22 <= -row_.thirds_reach_q22()) {
      return side(with_sign(a.value_q22, fields.sign), out);
    }
    const Point b = at(1, x_q8);
    const Point c = at(2, x_q8);
    const int32_t least = plain(a.value_q22, b.value_q22, c.value_q22);
    if (is_far(least)) {
      return side(with_sign(least, fields.sign), out);
    }
    const int32_t rounded = row_.least_of_three(fields, a.value_q22,
                                                b.value_q22, c.value_q22, x_q8);
    return put(plain(a.before(), b.before(), c.before()), least,
               plain(a.behind(), b.behind(), c.behind()), rounded - least, out);
  }

  Fields fields;

 private:
  // It may wrap: beyond the reach distances may be any.
  static int32_t sum(int32_t a, int32_t b) noexcept {
    return wrapped(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
  }

  // With the leaf's sign.
  struct Point {
    int32_t value_q22;
    int32_t gain_q22;

    int32_t before() const noexcept { return sum(value_q22, -gain_q22); }
    int32_t behind() const noexcept { return sum(value_q22, gain_q22); }
  };

  Point at(uint32_t i, uint32_t x_q8) const noexcept {
    int32_t slope_q14 = 0;
    const int32_t value = row_.value(fields.place[i], x_q8, slope_q14);
    return {with_sign(value, fields.sign),
            with_sign(slope_q14 * kThirdQ8, fields.sign)};
  }
  bool is_far(int32_t value_q22) const noexcept {
    const int32_t far_q22 = row_.thirds_reach_q22();
    return value_q22 <= -far_q22 || value_q22 >= far_q22;
  }
  // What is left of three values, without rounding.
  int32_t plain(int32_t a, int32_t b, int32_t c) const noexcept {
    return lesser(a, fields.is_nested ? greater(b, c) : lesser(b, c));
  }
  int32_t* put(int32_t before,
               int32_t at,
               int32_t behind,
               int32_t change,
               int32_t* out) const noexcept {
    out[0] = with_sign(sum(before, change), fields.sign);
    out[1] = with_sign(sum(at, change), fields.sign);
    out[2] = with_sign(sum(behind, change), fields.sign);
    return out + 3;
  }

  const FieldRow& row_;
};

void FieldRow::take_thirds(RowPoint at,
                           int32_t* out,
                           int32_t count) const noexcept {
  take_with<ThirdValues>(at, out, count);
}

}  // namespace detail
}  // namespace inkcell
