// Rows of points in threes.
#include "field_row.hpp"
#include "order.hpp"

namespace inkcell {
namespace detail {

// What a field is at a point, and how much it gains on the way to the next.
class FieldRow::ThirdValues {
 public:
  // What all leaves have in common.
  struct Way {
    int32_t way_q8;
    int32_t far_q22;
    int32_t across;  // -1 or 0
  };
  ThirdValues(const FieldRow& row, const Way& way) noexcept
      : row_(row), way_(way) {}

  static int32_t* side(int32_t value, int32_t* out) noexcept {
    out[1] = value;
    return out + 3;
  }

  __attribute__((always_inline)) int32_t* one(uint32_t x_q8,
                                              int32_t* out) const noexcept {
    const Point a = at(0, x_q8, 0);
    out[0] = a.before();
    out[1] = a.value_q22;
    out[2] = a.behind();
    return out + 3;
  }

  __attribute__((always_inline)) int32_t* two(uint32_t x_q8,
                                              int32_t* out) const noexcept {
    const int32_t sign = fields.sign;
    const Point a = at(0, x_q8, sign);
    if (a.value_q22 <= -way_.far_q22) {
      return side(with_sign(a.value_q22, sign), out);
    }
    const Point b = at(1, x_q8, sign);
    const bool in_order = a.value_q22 <= b.value_q22;
    const int32_t least = in_order ? a.value_q22 : b.value_q22;
    if (is_far(least)) {
      return side(with_sign(least, sign), out);
    }
    int32_t change = 0;
    if (row_.is_near_vertex(least, in_order ? b.value_q22 : a.value_q22)) {
      change = row_.rounded_two(fields, a.value_q22, b.value_q22, x_q8) - least;
    }
    return put(lesser(a.before(), b.before()), least,
               lesser(a.behind(), b.behind()), change, sign, out);
  }

  __attribute__((always_inline)) int32_t* three(uint32_t x_q8,
                                                int32_t* out) const noexcept {
    const int32_t sign = fields.sign;
    const Point a = at(0, x_q8, sign);
    if (a.value_q22 <= -way_.far_q22) {
      return side(with_sign(a.value_q22, sign), out);
    }
    const Point b = at(1, x_q8, sign);
    const Point c = at(2, x_q8, sign);
    const int32_t least = plain(a.value_q22, b.value_q22, c.value_q22);
    if (is_far(least)) {
      return side(with_sign(least, sign), out);
    }
    const int32_t rounded = row_.least_of_three(fields, a.value_q22,
                                                b.value_q22, c.value_q22, x_q8);
    return put(plain(a.before(), b.before(), c.before()), least,
               plain(a.behind(), b.behind(), c.behind()), rounded - least, sign,
               out);
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

    int32_t before() const noexcept {
      return wrapped(static_cast<uint32_t>(value_q22) -
                     static_cast<uint32_t>(gain_q22));
    }
    int32_t behind() const noexcept { return sum(value_q22, gain_q22); }
  };

  // The slope is that of FieldTerm along the way: nx - 2 k w ny to the right,
  // ny + 2 k w nx upwards.
  __attribute__((always_inline)) Point at(uint32_t i,
                                          uint32_t x_q8,
                                          int32_t sign) const noexcept {
    namespace layout = format::fields;
    const uint32_t place = fields.place[i];
    const int32_t across = way_.across;
    constexpr uint32_t kBoth = layout::kNormalX + layout::kNormalY;
    const uint32_t normal = across == 0 ? layout::kNormalX : layout::kNormalY;
    int32_t slope_q14 = load_i16(row_.cells_ + (place & ~uint32_t{1}) + normal);
    const int32_t value =
        row_.value(place, x_q8, [&](const uint8_t* record, uint32_t half_q15) {
          const int32_t other = load_i16(record + (kBoth - normal));
          slope_q14 -= wrapped(times(with_sign(other, across), half_q15)) >> 14;
        });
    return {with_sign(value, sign),
            wrapped(times(slope_q14, static_cast<uint32_t>(
                                         with_sign(way_.way_q8, sign))))};
  }
  bool is_far(int32_t value_q22) const noexcept {
    return value_q22 <= -way_.far_q22 || value_q22 >= way_.far_q22;
  }
  // What is left of three values, without rounding.
  int32_t plain(int32_t a, int32_t b, int32_t c) const noexcept {
    return lesser(a, fields.is_nested ? greater(b, c) : lesser(b, c));
  }
  static int32_t* put(int32_t before,
                      int32_t at,
                      int32_t behind,
                      int32_t change,
                      int32_t sign,
                      int32_t* out) noexcept {
    // With the sign: (x ^ sign) - sign.
    const int32_t more = sum(with_sign(change, sign), -sign);
    out[0] = sum(before ^ sign, more);
    out[1] = sum(at ^ sign, more);
    out[2] = sum(behind ^ sign, more);
    return out + 3;
  }

  const FieldRow& row_;
  const Way& way_;
};

void FieldRow::take_thirds(RowPoint at,
                           const ThirdsWay& way,
                           int32_t* out,
                           int32_t count) const noexcept {
  const ThirdValues::Way same = {way.way_q8, reach_q22(way),
                                 way.is_across ? -1 : 0};
  take_with<ThirdValues>(at, out, count, same);
}

}  // namespace detail
}  // namespace inkcell
