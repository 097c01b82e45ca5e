// Rows of points in threes.
#include "field_row.hpp"
#include "order.hpp"

namespace inkcell {
namespace detail {

// What a field is at a point, and how much it gains on the way to the next.
class FieldRow::ThirdValues {
 public:
  ThirdValues(const FieldRow& row, const ThirdsWay& way) noexcept
      : row_(row), way_(way) {}

  // Once the fields are read. The slope is that of FieldTerm along the way: nx
  // - 2 k w ny to the right, ny + 2 k w nx upwards.
  __attribute__((noinline)) void set_up(uint32_t count) noexcept {
    namespace layout = format::fields;
    const uint8_t* const cells = row_.cells_;
    const uint32_t y_q8 = row_.y_q8_;
    const FieldScale scale = row_.scale_;
    const uint32_t normal = way_.normal;
    const int32_t sign = fields.sign;
    const int32_t way_q8 = with_sign(way_.way_q8, sign);
    const uint32_t* place = fields.place;
    Term* term = terms_;
    for (const uint32_t* const end = place + count; place != end; ++term) {
      const uint32_t where = *place++;
      const uint8_t* const at = cells + (where & ~uint32_t{1});
      const int32_t nx = load_i16(at + layout::kNormalX);
      const int32_t ny = load_i16(at + layout::kNormalY);
      const uint32_t value =
          times(ny, y_q8) +
          times(load_i16(at + layout::kOffset), scale.size_q8);
      term->value_q22 = static_cast<uint32_t>(with_sign(wrapped(value), sign));
      term->nx_q14 = static_cast<int16_t>(with_sign(nx, sign));
      term->gain_q22 =
          times(load_i16(at + normal), static_cast<uint32_t>(way_q8));
      term->bend = 0;
      if ((where & 1) != 0) {
        term->bend =
            (load_i16(at + layout::kBend) * scale.bend_q14 + (1 << 10)) >> 11;
        term->along_q22 = times(nx, y_q8) + (1 << 13) +
                          times(load_i16(at + layout::kAlong), scale.size_q8);
        term->ny_q14 = static_cast<int16_t>(ny);
        term->other_q14 = normal == layout::kNormalX ? ny : -nx;
      }
    }
  }

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

  // A field along the row, with the leaf's sign: what does not change from
  // point to point.
  struct Term {
    uint32_t value_q22;  // at x = 0, of the plane
    uint32_t gain_q22;   // of the plane
    int32_t bend;  // of FieldTerm, 0 for a line; without the sign, as below
    uint32_t along_q22;  // at x = 0
    int16_t nx_q14;
    int16_t ny_q14;
    int32_t other_q14;  // of the normal across the way
  };

  __attribute__((always_inline)) Point at(uint32_t i,
                                          uint32_t x_q8,
                                          int32_t sign) const noexcept {
    const Term& term = terms_[i];
    uint32_t value = term.value_q22 + times(term.nx_q14, x_q8);
    uint32_t gain = term.gain_q22;
    if (term.bend != 0) {
      const auto along = static_cast<uint32_t>(
          wrapped(term.along_q22 - times(term.ny_q14, x_q8)) >> 14);
      const auto half_q15 = static_cast<uint32_t>(
          wrapped(times(term.bend, along)) >> row_.bend_shift_);
      value += static_cast<uint32_t>(
          with_sign(wrapped(half_q15 * along) >> 1, sign));
      gain -= times(wrapped(times(term.other_q14, half_q15)) >> 14,
                    static_cast<uint32_t>(with_sign(way_.way_q8, sign)));
    }
    return {wrapped(value), wrapped(gain)};
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
  const ThirdsWay& way_;
  Term terms_[3];
};

void FieldRow::take_thirds(RowPoint at,
                           const ThirdsWay& way,
                           int32_t* out,
                           int32_t count) const noexcept {
  take_with<ThirdValues>(at, out, count, way);
}

}  // namespace detail
}  // namespace inkcell
