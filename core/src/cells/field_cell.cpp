#include "cells/field_cell.hpp"

namespace inkcell {
namespace detail {
namespace {

constexpr int32_t kOneQ14 = 1 << 14;

// The root rounded down.
uint32_t root(uint32_t value) noexcept {
#if defined(__ARM_FEATURE_IDIV) || defined(__x86_64__)
  if (value == 0) {
    return 0;
  }
  // Newton's steps, from a power of two that is no less: each but the last one
  // leads further down, and none below the root, so that there are few.
  uint32_t result = uint32_t{1} << (16 - (__builtin_clz(value) >> 1));
  while (true) {
    const uint32_t next = (result + value / result) >> 1;
    if (next >= result) {
      return result;
    }
    result = next;
  }
#else
  // Bit by bit.
  uint32_t result = 0;
  uint32_t bit = uint32_t{1} << 30;
  while (bit > value) {
    bit >>= 2;
  }
  for (; bit != 0; bit >>= 2) {
    const uint32_t sum = result + bit;
    result >>= 1;
    if (value >= sum) {
      value -= sum;
      result += bit;
    }
  }
  return result;
#endif
}

// Two values a and b of which the lesser is negative, as seen from the vertex
// where both are 0: with unit gradients g and h and c = g.h, the distance from
// it is |q|, g.q = a and h.q = b.
//
//   inside  |                  The vertex is the nearest point of the edge
//   . . . . V------  g         where q = (a - c b) g + (b - c a) h, but for a
//    h |   /  edge             positive factor, points away from both fields.
//      | q/
//        p
struct Cone {
  int32_t a;  // scaled to 12 bits, both
  int32_t b;
  int32_t a_bc_q14;  // a - c b
  int32_t b_ac_q14;  // b - c a
  int32_t c_q14;
  int32_t scale_log2;
};

// Whether two values, the lesser below 0, may have a vertex near: |c| < 1, so
// that else q would not point away from both.
bool may_meet(int32_t lesser_q22, int32_t greater_q22) noexcept {
  return greater_q22 <= 0 || static_cast<uint32_t>(greater_q22) <
                                 0u - static_cast<uint32_t>(lesser_q22);
}

// Whether a point lies in the cone of the vertex, given the cosine of the angle
// between the gradients. Fields that are nearly parallel (1 - c^2 below 0.022)
// have none.
__attribute__((always_inline)) inline bool find_cone(int32_t a_q22,
                                                     int32_t b_q22,
                                                     int32_t c_q14,
                                                     Cone& cone) noexcept {
  constexpr int32_t kMaxCosineQ14 = 16202;
  const uint32_t size =
      0u - static_cast<uint32_t>(a_q22 < b_q22 ? a_q22 : b_q22);
  if (c_q14 > kMaxCosineQ14 || c_q14 < -kMaxCosineQ14) {
    return false;
  }
  int32_t log2 = size >> 8 >= 1u << 12 ? 8 : 0;  // half of the steps at once
  while (size >> log2 >= 1u << 12) {
    ++log2;
  }
  cone.a = a_q22 >> log2;
  cone.b = b_q22 >> log2;
  cone.a_bc_q14 = cone.a * kOneQ14 - c_q14 * cone.b;
  cone.b_ac_q14 = cone.b * kOneQ14 - c_q14 * cone.a;
  cone.c_q14 = c_q14;
  cone.scale_log2 = log2;
  return cone.a_bc_q14 <= 0 && cone.b_ac_q14 <= 0;
}

// |q|: hypot(a, (b - c a) / sqrt(1 - c^2)).
int32_t length_q22(const Cone& cone) noexcept {
  const auto sine_q14 =
      root(static_cast<uint32_t>((1 << 28) - cone.c_q14 * cone.c_q14));
  // At most 2^13 over 0.148, so that the sum of squares is below 2^32.
  const uint32_t other = static_cast<uint32_t>(-cone.b_ac_q14) / sine_q14;
  const uint32_t length =
      root(static_cast<uint32_t>(cone.a * cone.a) + other * other);
  if (length > static_cast<uint32_t>(INT32_MAX) >> cone.scale_log2) {
    return INT32_MAX;
  }
  return static_cast<int32_t>(length << cone.scale_log2);
}

// The lesser of two values, rounded at their vertex. Their order does not
// matter, though the roundings in a cone are not symmetric: records may name a
// pair's fields in either.
int32_t least_q22(int32_t a_q22,
                  const FieldTerm& a_term,
                  int32_t b_q22,
                  const FieldTerm& b_term,
                  int32_t bend_shift,
                  int32_t reach_q22) noexcept {
  const bool in_order = a_q22 <= b_q22;
  const int32_t lesser = in_order ? a_q22 : b_q22;
  const int32_t greater = in_order ? b_q22 : a_q22;
  if (lesser >= 0 || lesser <= -reach_q22 || !may_meet(lesser, greater)) {
    return lesser;
  }
  return rounded_q22(lesser, greater,
                     cosine_q14(gradient_q14(a_term, bend_shift),
                                gradient_q14(b_term, bend_shift)));
}

int32_t negated(int32_t value) noexcept {
  return wrapped(0u - static_cast<uint32_t>(value));
}

// The two values that are left when all but the last step is done, negated if
// the operator asks for the greatest.
struct LastTwo {
  int32_t a_q22;
  int32_t b_q22;
  const FieldTerm* a_term;
  const FieldTerm* b_term;
};

bool is_negated(Csg op) noexcept {
  return (static_cast<uint8_t>(op) & 1) != 0;
}

bool is_nested(Csg op) noexcept {
  return op >= Csg::intersection_of_union;
}

// `terms` are two or three.
LastTwo last_two(const FieldTerms& terms,
                 int32_t bend_shift,
                 int32_t reach_q22) noexcept {
  int32_t value[3];
  for (uint32_t i = 0; i < terms.count; ++i) {
    const int32_t plain = terms.term[i].value_q22(bend_shift);
    value[i] = is_negated(terms.op) ? negated(plain) : plain;
  }
  const FieldTerm* term = terms.term;
  if (terms.count == 2) {
    return {value[0], value[1], term, term + 1};
  }
  if (is_nested(terms.op)) {
    const int32_t inner =
        negated(least_q22(negated(value[1]), term[1], negated(value[2]),
                          term[2], bend_shift, reach_q22));
    return {value[0], inner, term, value[1] >= value[2] ? term + 1 : term + 2};
  }
  // Without the greatest.
  if (value[0] > value[1] && value[0] > value[2]) {
    return {value[1], value[2], term + 1, term + 2};
  }
  return value[1] > value[2] ? LastTwo{value[0], value[2], term, term + 2}
                             : LastTwo{value[0], value[1], term, term + 1};
}

Gradient unit_vector(Vector v) noexcept {
  while (v.x >= kOneQ14 || v.x < -kOneQ14 || v.y >= kOneQ14 || v.y < -kOneQ14) {
    v.x >>= 1;
    v.y >>= 1;
  }
  const uint32_t length = root(static_cast<uint32_t>(v.x * v.x + v.y * v.y));
  Gradient result;
  if (length != 0) {
    const auto part = [length](int32_t x) noexcept {
      const auto size = static_cast<uint32_t>(x < 0 ? -x : x);
      const auto q14 = static_cast<int32_t>((size << 14) / length);
      return static_cast<int16_t>(x < 0 ? -q14 : q14);
    };
    result.x.raw = part(v.x);
    result.y.raw = part(v.y);
  }
  return result;
}

bool is_rounded(const LastTwo& two,
                const Vector& g,
                const Vector& h,
                Cone& cone) noexcept {
  const int32_t lesser = two.a_q22 < two.b_q22 ? two.a_q22 : two.b_q22;
  const int32_t greater = two.a_q22 < two.b_q22 ? two.b_q22 : two.a_q22;
  return lesser < 0 && may_meet(lesser, greater) &&
         find_cone(two.a_q22, two.b_q22, cosine_q14(g, h), cone);
}

}  // namespace

uint32_t read_linked_leaf(const GlyphField& field,
                          uint32_t reference,
                          uint16_t* out,
                          Csg& op) noexcept {
  return LinkedHeap(field).read_leaf(
      reference, [](uint32_t unit) { return static_cast<uint16_t>(unit); }, out,
      op);
}

Cell locate_fields(const GlyphField& field, int32_t x_u, int32_t y_u) noexcept {
  const uint32_t x = static_cast<uint32_t>(x_u - field.x0_u);
  const uint32_t y = static_cast<uint32_t>(y_u - field.y0_u);
  const uint32_t tile =
      (y >> field.tile_log2) * field.tiles_x + (x >> field.tile_log2);
  const bool is_narrow = field.kind == GlyphField::Kind::narrow_fields;
  const Leaf leaf =
      is_narrow ? find_narrow_leaf(field, tile, x, y)
                : LinkedHeap(field).find_leaf(tile, field.tile_log2, x, y);
  Cell cell;
  cell.inside = leaf.reference == format::glyph::kInside;
  if (leaf.reference >= format::glyph::kFirstNode) {
    cell.field_count = static_cast<uint8_t>(
        is_narrow
            ? read_narrow_leaf(field, leaf.reference, cell.fields, cell.op)
            : read_linked_leaf(field, leaf.reference, cell.fields, cell.op));
  }
  const uint32_t log2 = leaf.size_log2;
  cell.size_log2 = static_cast<uint8_t>(log2);
  cell.x0_u = field.x0_u + static_cast<int32_t>((x >> log2) << log2);
  cell.y0_u = field.y0_u + static_cast<int32_t>((y >> log2) << log2);
  return cell;
}

int32_t rounded_q22(int32_t lesser_q22,
                    int32_t greater_q22,
                    int32_t c_q14) noexcept {
  Cone cone;
  return find_cone(lesser_q22, greater_q22, c_q14, cone) ? -length_q22(cone)
                                                         : lesser_q22;
}

int32_t combine_q22(const FieldTerms& terms,
                    int32_t bend_shift,
                    int32_t reach_q22) noexcept {
  const FieldTerm* term = terms.term;
  const int32_t first = term[0].value_q22(bend_shift);
  if (terms.count == 1) {
    return first;
  }
  // Pairs are frequent enough to have a way of their own.
  const bool is_greatest = is_negated(terms.op);
  LastTwo two = {};
  if (terms.count == 2) {
    const int32_t second = term[1].value_q22(bend_shift);
    two = is_greatest ? LastTwo{negated(first), negated(second), term, term + 1}
                      : LastTwo{first, second, term, term + 1};
  } else {
    two = last_two(terms, bend_shift, reach_q22);
  }
  const int32_t least = least_q22(two.a_q22, *two.a_term, two.b_q22,
                                  *two.b_term, bend_shift, reach_q22);
  return is_greatest ? negated(least) : least;
}

Gradient combined_gradient(const FieldTerms& terms,
                           int32_t bend_shift) noexcept {
  if (terms.count == 1) {
    return unit_vector(gradient_q14(terms.term[0], bend_shift));
  }
  const LastTwo two = last_two(terms, bend_shift, kNoReach);
  const Vector g = gradient_q14(*two.a_term, bend_shift);
  const Vector h = gradient_q14(*two.b_term, bend_shift);
  Cone cone;
  if (is_rounded(two, g, h, cone)) {
    const int32_t a = -cone.a_bc_q14 >> 15;
    const int32_t b = -cone.b_ac_q14 >> 15;
    return unit_vector({a * g.x + b * h.x, a * g.y + b * h.y});
  }
  if (two.a_q22 < two.b_q22) {
    return unit_vector(g);
  }
  if (terms.count == 3 && is_nested(terms.op)) {
    const FieldTerms inner = {
        {terms.term[1], terms.term[2]},
        2,
        is_negated(terms.op) ? Csg::intersection : Csg::union_};
    return combined_gradient(inner, bend_shift);  // which is not nested
  }
  return unit_vector(h);
}

}  // namespace detail
}  // namespace inkcell
