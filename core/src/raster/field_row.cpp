// Rows of points in threes.
#include "raster/field_row.hpp"

namespace inkcell {
namespace detail {
namespace {

// It may wrap: beyond the reach distances may be any.
int32_t sum(int32_t a, int32_t b) noexcept {
  return wrapped(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
}

// What a field is at a point, and how much it gains on the way to the next,
// with the leaf's sign.
struct Third {
  int32_t value_q22;
  int32_t gain_q22;

  int32_t before() const noexcept {
    return wrapped(static_cast<uint32_t>(value_q22) -
                   static_cast<uint32_t>(gain_q22));
  }
  int32_t behind() const noexcept { return sum(value_q22, gain_q22); }
};

// The way to the next point, with the leaf's sign, and what else does not
// change along a row.
struct SignedWay {
  uint32_t normal;
  int32_t way_q8;
  int32_t bend_shift;
  int32_t sign;
};

// A line along a row.
struct ThirdLine {
  LineTerm plane;
  int32_t gain_q22;

  __attribute__((always_inline)) ThirdLine(const uint8_t* field,
                                           PixelPlace place,
                                           const FieldScale& scale,
                                           const SignedWay& way) noexcept
      : plane(field, place, scale, way.sign),
        gain_q22(wrapped(times(load_i16(field + way.normal),
                               static_cast<uint32_t>(way.way_q8)))) {}

  Third at(const SignedWay&) const noexcept {
    return {wrapped(plane.plane_q22), gain_q22};
  }

  void go_on() noexcept { plane.go_on(); }
};

// A line or an arc. The slope is that of FieldTerm along the way: nx - 2 k w ny
// to the right, ny + 2 k w nx upwards.
struct ThirdArc {
  ArcTerm arc;
  uint32_t gain_q22;  // of the plane
  int32_t other_q14;  // of the normal across the way

  __attribute__((always_inline)) ThirdArc(const uint8_t* field,
                                          PixelPlace place,
                                          const FieldScale& scale,
                                          const SignedWay& way) noexcept
      : arc(field, place, scale, way.sign) {
    namespace layout = format::edges;
    const uint8_t* const record = field - arc_bit(field);
    gain_q22 =
        times(load_i16(record + way.normal), static_cast<uint32_t>(way.way_q8));
    other_q14 = way.normal == layout::kNormalX
                    ? load_i16(record + layout::kNormalY)
                    : -load_i16(record + layout::kNormalX);
  }

  __attribute__((always_inline)) Third at(const SignedWay& way) const noexcept {
    const auto half_q15 = static_cast<uint32_t>(arc.slope_q15(way.bend_shift));
    const uint32_t gain =
        gain_q22 - times(wrapped(times(other_q14, half_q15)) >> 14,
                         static_cast<uint32_t>(way.way_q8));
    return {arc.value(way.bend_shift, way.sign), wrapped(gain)};
  }

  void go_on() noexcept { arc.go_on(); }
};

}  // namespace

// Draws the points of one leaf that has fields.
class FieldRow::Thirds {
 public:
  __attribute__((always_inline)) Thirds(const FieldRow& row,
                                        const ThirdsWay& way,
                                        const FieldLeaf& leaf,
                                        const uint32_t& number) noexcept
      : row_(row),
        leaf_(leaf),
        far_q22_(way.far_q22),
        way_{way.normal, with_sign(way.way_q8, leaf.sign), row.bend_shift(),
             leaf.sign},
        number_(number) {}

  // `next` is asked after each point whether there is one more.
  template <typename Term, typename Next>
  __attribute__((always_inline)) int32_t* draw(int32_t* out,
                                               const Next& next) noexcept {
    const auto term = [&](int i) __attribute__((always_inline)) {
      return Term(leaf_.field[i], leaf_.place, row_.scale_, way_);
    };
    if (leaf_.count == 1) {
      Term a = term(0);
      while (true) {
        out = put(a.at(way_), out);
        if (!next()) {
          return out;
        }
        a.go_on();
      }
    }
    if (leaf_.count == 2) {
      Term a = term(0);
      Term b = term(1);
      while (true) {
        out = two(a.at(way_), b.at(way_), out);
        if (!next()) {
          return out;
        }
        a.go_on();
        b.go_on();
      }
    }
    Term a = term(0);
    Term b = term(1);
    Term c = term(2);
    while (true) {
      out = three(a.at(way_), b.at(way_), c.at(way_), out);
      if (!next()) {
        return out;
      }
      a.go_on();
      b.go_on();
      c.go_on();
    }
  }

  static int32_t* side(int32_t value, int32_t* out) noexcept {
    out[1] = value;
    return out + 3;
  }

 private:
  __attribute__((always_inline)) static int32_t* put(const Third& a,
                                                     int32_t* out) noexcept {
    out[0] = a.before();
    out[1] = a.value_q22;
    out[2] = a.behind();
    return out + 3;
  }

  __attribute__((always_inline)) int32_t* two(const Third& a,
                                              const Third& b,
                                              int32_t* out) const noexcept {
    const int32_t least = min(a.value_q22, b.value_q22);
    if (is_far(least)) {
      return side(with_sign(least, way_.sign), out);
    }
    const int32_t rounded =
        row_.least_of_two(leaf_, a.value_q22, b.value_q22, RowNumber{number_});
    return put(min(a.before(), b.before()), least, min(a.behind(), b.behind()),
               rounded - least, out);
  }

  __attribute__((always_inline)) int32_t* three(const Third& a,
                                                const Third& b,
                                                const Third& c,
                                                int32_t* out) const noexcept {
    const int32_t least = plain(a.value_q22, b.value_q22, c.value_q22);
    if (is_far(least)) {
      return side(with_sign(least, way_.sign), out);
    }
    const int32_t rounded = row_.least_of_three(
        leaf_, a.value_q22, b.value_q22, c.value_q22, RowNumber{number_});
    return put(plain(a.before(), b.before(), c.before()), least,
               plain(a.behind(), b.behind(), c.behind()), rounded - least, out);
  }

  // |value| >= far.
  __attribute__((always_inline)) bool is_far(int32_t value_q22) const noexcept {
    const auto far = static_cast<uint32_t>(far_q22_);
    return static_cast<uint32_t>(value_q22) + far - 1 >= 2 * far - 1;
  }
  // What is left of three values, without rounding.
  __attribute__((always_inline)) int32_t plain(int32_t a,
                                               int32_t b,
                                               int32_t c) const noexcept {
    return min(a, leaf_.is_nested ? max(b, c) : min(b, c));
  }
  __attribute__((always_inline)) int32_t* put(int32_t before,
                                              int32_t at,
                                              int32_t behind,
                                              int32_t change,
                                              int32_t* out) const noexcept {
    // With the sign: (x ^ sign) - sign.
    const int32_t sign = way_.sign;
    const int32_t more = sum(with_sign(change, sign), -sign);
    out[0] = sum(before ^ sign, more);
    out[1] = sum(at ^ sign, more);
    out[2] = sum(behind ^ sign, more);
    return out + 3;
  }

  const FieldRow& row_;
  const FieldLeaf& leaf_;
  int32_t far_q22_;
  SignedWay way_;
  const uint32_t& number_;  // of the point, in its leaf
};

void FieldRow::take_thirds(RowPoint at,
                           const ThirdsWay& way,
                           int32_t* out,
                           int32_t count) const noexcept {
  const uint32_t step = step_q16_;
  uint32_t x_q16 = at.x_q16;
  auto x_q8 = static_cast<uint32_t>(wrapped(at.x_q20) >> 12);
  const uint32_t end_q16 = x_q16 + static_cast<uint32_t>(count) * step;
  while (x_q16 < end_q16) {
    FieldLeaf leaf;
    find_leaf(x_q16 >> 16, y_u_, leaf);
    leaf.place = {x_q8, y_q8_};
    const uint32_t stop_q16 = stop_of(leaf, x_q16, end_q16);
    uint32_t number = 0;
    const auto next = [&]() __attribute__((always_inline)) {
      ++number;
      x_q16 += step;
      return x_q16 < stop_q16;
    };
    Thirds thirds(*this, way, leaf, number);
    if (leaf.count == 0) {
      const int32_t side = leaf.is_inside ? INT32_MAX : INT32_MIN;
      do {
        out = Thirds::side(side, out);
      } while (next());
    } else if (kFastRows && leaf.has_lines(leaf.count)) {
      out = thirds.draw<ThirdLine>(out, next);
    } else {
      out = thirds.draw<ThirdArc>(out, next);
    }
    x_q8 += number << 8;
  }
}

}  // namespace detail
}  // namespace inkcell
