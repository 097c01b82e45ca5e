// Slanted rows of cells of fields.
//
// Along a row a leaf is kept while points stay in its square. A pixel is
// evaluated no further than to the first field that decides it; only where a
// vertex may be near, or edges are stretched, are terms set up. Wide cells are
// drawn in runs, whose fields are looked at from both ends first: those that
// are saturated there, and so between, are left out. fields_distance_q10 and
// stretched_fields_q10 give the same coverage bit by bit.
#include "field_slanted.hpp"

#include "field_turned.hpp"
#include "order.hpp"

namespace inkcell {
namespace detail {
namespace {

inline int32_t value_at(const Slanted& slanted,
                        const SlantedLeaf& leaf,
                        uint32_t i,
                        const PointQ8& at) noexcept {
  FieldTerm term;
  set_up_term(term, slanted.field, leaf.units[i], at.x, at.y, slanted.scale);
  return with_sign(term.value_q22(slanted.scale.bend_log2), leaf.sign);
}

// The lesser of the values of fields i and j, rounded at their vertex.
__attribute__((noinline)) int32_t rounded_at(const Slanted& slanted,
                                             const SlantedLeaf& leaf,
                                             uint32_t i,
                                             uint32_t j,
                                             const int32_t* values,
                                             const PointQ8& at) noexcept {
  const auto gradient = [&slanted, &at](uint32_t unit) noexcept {
    return gradient_q14(slanted.field, unit, at.x, at.y, slanted.scale);
  };
  return rounded_q22(values[i], gradient(leaf.units[i]), values[j],
                     gradient(leaf.units[j]));
}

// The lesser of two values, rounded where that changes coverage: where the
// greater one is farther from 0 no vertex is near.
inline int32_t least_of(const Slanted& slanted,
                        const SlantedLeaf& leaf,
                        uint32_t i,
                        uint32_t j,
                        const int32_t* values,
                        const PointQ8& at) noexcept {
  if (values[i] > values[j]) {
    const uint32_t other = i;
    i = j;
    j = other;
  }
  const int32_t lesser = values[i];
  if (lesser < 0 && lesser > -slanted.reach_q22 && lesser + values[j] < 0) {
    return rounded_at(slanted, leaf, i, j, values, at);
  }
  return lesser;
}

// The distance of three fields, or what is as far on the same side.
__attribute__((noinline)) int32_t triple_at(const Slanted& slanted,
                                            const SlantedLeaf& leaf,
                                            const PointQ8& at) noexcept {
  int32_t values[3];
  values[0] = value_at(slanted, leaf, 0, at);
  if (values[0] <= -slanted.far_q22) {
    return values[0];
  }
  values[1] = value_at(slanted, leaf, 1, at);
  values[2] = value_at(slanted, leaf, 2, at);
  if (slanted.stretch != nullptr) {
    return slanted.stretch(slanted, leaf, at);
  }
  uint32_t first = 0;
  uint32_t second = 1;
  if (leaf.op >= FieldOperator::least_of_greater) {
    values[1] = with_sign(values[1], -1);
    values[2] = with_sign(values[2], -1);
    const int32_t inner =
        with_sign(least_of(slanted, leaf, 1, 2, values, at), -1);
    second = values[1] <= values[2] ? 1 : 2;
    values[second] = inner;
  } else if (values[0] > values[1] && values[0] > values[2]) {
    first = 1;  // without the greatest
    second = 2;
  } else if (values[1] > values[2]) {
    second = 2;
  }
  return least_of(slanted, leaf, first, second, values, at);
}

// The same of one or two.
inline int32_t pair_at(const Slanted& slanted,
                       const SlantedLeaf& leaf,
                       const PointQ8& at) noexcept {
  const int32_t far = slanted.far_q22;
  int32_t values[2];
  values[0] = value_at(slanted, leaf, 0, at);
  int32_t least = values[0];
  if (leaf.count == 2 && least > -far) {
    values[1] = value_at(slanted, leaf, 1, at);
    if (slanted.stretch == nullptr) {
      return least_of(slanted, leaf, 0, 1, values, at);
    }
    least = least < values[1] ? least : values[1];
  }
  return slanted.stretch != nullptr && least < far && least > -far
             ? slanted.stretch(slanted, leaf, at)
             : least;
}

// The ends of a stretch of a row within a cell.
struct SlantedRun {
  PointQ8 first;
  PointQ8 last;
};

// What a field shows of a run: nothing, all, or what its values say.
enum class Side : int8_t { outside, edge, inside };

// From a nearer distance than this, 256 px, nothing wraps within a run.
bool is_far(int32_t value_q22) noexcept {
  constexpr int32_t kFar = 1 << 30;
  return value_q22 >= kFar || value_q22 <= -kFar;
}

// By how much a bent field may differ from the chord between two points of a
// run. INT32_MAX if something may wrap, and nothing is known. [px, Q22]
int32_t sag_of(const FieldTerm& first,
               const FieldTerm& last,
               int32_t bend_log2) noexcept {
  const int32_t ways_q8[] = {first.along_q8(), last.along_q8()};
  const int32_t slopes_q15[] = {first.slope_q15(bend_log2),
                                last.slope_q15(bend_log2)};
  for (int i = 0; i < 2; ++i) {
    // w stays below 256 px and k w below 1.
    const int32_t way = magnitude(ways_q8[i]);
    if (way >= 1 << 16 || magnitude(slopes_q15[i]) >= 1 << 15 ||
        magnitude(first.bend >> 4) * way >= 1 << 27) {
      return INT32_MAX;
    }
  }
  // A parabola stays within a quarter of the change of its slope times the way
  // along it, k (dw)^2 / 4, of the chord.
  const auto change =
      static_cast<uint32_t>(magnitude(slopes_q15[1] - slopes_q15[0]));
  const auto way = static_cast<uint32_t>(magnitude(ways_q8[1] - ways_q8[0]));
  const uint32_t sag = change * way;  // below 2^16 times 2^17
  return change >= 1u << 15 || way >= 1u << 16 ? INT32_MAX
                                               : static_cast<int32_t>(sag >> 3);
}

Side side_of(const Slanted& slanted,
             const SlantedLeaf& leaf,
             uint32_t i,
             const SlantedRun& run) noexcept {
  constexpr int32_t kMargin = 1 << 18;  // more than all roundings
  const int32_t bend_log2 = slanted.scale.bend_log2;
  FieldTerm first;
  set_up_term(first, slanted.field, leaf.units[i], run.first.x, run.first.y,
              slanted.scale);
  const int32_t first_q22 = with_sign(first.value_q22(bend_log2), leaf.sign);
  if (is_far(first_q22) || magnitude(first_q22) < slanted.far_q22) {
    return Side::edge;
  }
  FieldTerm last;
  set_up_term(last, slanted.field, leaf.units[i], run.last.x, run.last.y,
              slanted.scale);
  const int32_t last_q22 = with_sign(last.value_q22(bend_log2), leaf.sign);
  const int32_t sag_q22 = first.bend == 0 ? 0 : sag_of(first, last, bend_log2);
  const int32_t room_q22 = (1 << 30) - slanted.far_q22 - kMargin;
  if (is_far(last_q22) || sag_q22 >= room_q22) {
    return Side::edge;
  }
  const int32_t beyond_q22 = slanted.far_q22 + kMargin + sag_q22;
  if (first_q22 >= beyond_q22 && last_q22 >= beyond_q22) {
    return Side::inside;
  }
  return first_q22 <= -beyond_q22 && last_q22 <= -beyond_q22 ? Side::outside
                                                             : Side::edge;
}

// Drops the fields of a leaf that change no pixel of a run. What all show, as
// if the operator asked for the least; if that is an edge, some are left.
Side reduce(const Slanted& slanted,
            SlantedLeaf& leaf,
            const SlantedRun& run) noexcept {
  const uint32_t all = leaf.count;
  const bool is_nested = leaf.op >= FieldOperator::least_of_greater;
  Side sides[3] = {Side::edge, Side::edge, Side::edge};
  leaf.count = 0;
  for (uint32_t i = 0; i < all; ++i) {
    sides[i] = side_of(slanted, leaf, i, run);
    if (sides[i] == Side::outside && (i == 0 || !is_nested)) {
      return Side::outside;
    }
    if (sides[i] == Side::edge) {
      leaf.units[leaf.count++] = leaf.units[i];
    }
  }
  if (!is_nested || leaf.count == 3) {
    return leaf.count == 0 ? Side::inside : Side::edge;
  }
  // The first meets the greater of the other two.
  if (sides[1] == Side::outside && sides[2] == Side::outside) {
    return Side::outside;
  }
  const bool is_first_left = sides[0] == Side::edge;
  if (sides[1] == Side::inside || sides[2] == Side::inside) {
    leaf.count = is_first_left ? 1 : 0;
  } else if (!is_first_left) {
    leaf.sign = ~leaf.sign;  // the greater of the others is all
  }
  leaf.op = leaf.sign == 0 ? FieldOperator::least : FieldOperator::greatest;
  return leaf.count == 0 ? Side::inside : Side::edge;
}

// Pixels of a field, set up for the origin.
__attribute__((noinline)) void draw_field_pixels(Slanted& slanted,
                                                 const SlantedLeaf& leaf,
                                                 const RowPoint& from,
                                                 int32_t x,
                                                 int32_t end) noexcept {
  const Filter& filter = slanted.brush.filter();
  const GlyphStep& right = slanted.brush.right();
  uint32_t x_q20 = from.x_q20;
  uint32_t y_q20 = from.y_q20;
  FieldTerm term;
  set_up_term(term, slanted.field, leaf.units[0], 0, 0, slanted.scale);
  const FieldTerm origin = term;
  while (x < end) {
    const uint32_t x_q8 = q8_of(x_q20);
    const uint32_t y_q8 = q8_of(y_q20);
    term.plane_q22 = origin.plane_q22 + times(origin.nx_q14, x_q8) +
                     times(origin.ny_q14, y_q8);
    term.along_q22 = origin.along_q22 + times(origin.nx_q14, y_q8) -
                     times(origin.ny_q14, x_q8);
    const int32_t value_q22 = term.value_q22(slanted.scale.bend_log2);
    slanted.writer.append(filter.coverage(value_q22 >> 12), ++x);
    x_q20 += static_cast<uint32_t>(right.x_q20);
    y_q20 += static_cast<uint32_t>(right.y_q20);
  }
}

inline uint8_t coverage_at(const Slanted& slanted,
                           const SlantedLeaf& leaf,
                           const RowPoint& at) noexcept {
  const PointQ8 point = {q8_of(at.x_q20), q8_of(at.y_q20)};
  const int32_t value_q22 = leaf.count == 3 ? triple_at(slanted, leaf, point)
                                            : pair_at(slanted, leaf, point);
  return slanted.brush.filter().coverage(with_sign(value_q22, leaf.sign) >> 12);
}

// Pixels of a leaf, up to `end`.
__attribute__((noinline)) void draw_pixels(Slanted& slanted,
                                           const SlantedLeaf& leaf,
                                           const RowPoint& from,
                                           int32_t x,
                                           int32_t end) noexcept {
  slanted.writer.begin(x);
  if (leaf.count == 1 && slanted.stretch == nullptr) {
    draw_field_pixels(slanted, leaf, from, x, end);
    return;
  }
  for (RowPoint at = from; x < end; at.go(slanted.brush.right())) {
    slanted.writer.append(coverage_at(slanted, leaf, at), ++x);
  }
}

// What a run of a wide cell shows as a whole; if that is an edge, only fields
// that matter are left in `leaf`. Not inline, to be off the stack when pixels
// are drawn.
__attribute__((noinline)) Side side_of_run(const Slanted& slanted,
                                           SlantedLeaf& leaf,
                                           const RowPoint& at,
                                           uint32_t steps) noexcept {
  const GlyphStep& right = slanted.brush.right();
  const int32_t sign = leaf.sign;
  const Side side = reduce(slanted, leaf,
                           {{q8_of(at.x_q20), q8_of(at.y_q20)},
                            {q8_of(at.x_q20 + times(right.x_q20, steps)),
                             q8_of(at.y_q20 + times(right.y_q20, steps))}});
  if (side == Side::edge || sign == 0) {
    return side;
  }
  return side == Side::inside ? Side::outside : Side::inside;
}

// The leaf at a point, in u from the grid's corner.
inline Leaf find_leaf(const GlyphField& field,
                      uint32_t x,
                      uint32_t y) noexcept {
  const uint32_t tile =
      (y >> field.tile_log2) * field.tiles_x + (x >> field.tile_log2);
  return field.kind == GlyphField::Kind::narrow_fields
             ? find_narrow_leaf(field, tile, x, y)
             : find_linked_leaf(field, tile, x, y);
}

// What a leaf names: no fields, if one does not exist.
inline void read_leaf(const GlyphField& field,
                      uint32_t reference,
                      SlantedLeaf& leaf) noexcept {
  leaf.op = FieldOperator::least;
  leaf.count = field.kind == GlyphField::Kind::narrow_fields
                   ? read_narrow_leaf(field, reference, leaf.units, leaf.op)
                   : read_linked_leaf(field, reference, leaf.units, leaf.op);
  leaf.sign = -(static_cast<int32_t>(leaf.op) & 1);
}

// Cells that are so wide are drawn in runs. [px]
constexpr uint32_t kMinWide = 4;

// Shorter runs are drawn pixel by pixel all the same.
constexpr uint32_t kMinRun = 4;

// A run is cut after this many pixels: a field, of slope 8 a pixel at most,
// cannot wrap from one side to the other unseen.
constexpr uint32_t kMaxRun = 64;

}  // namespace

int32_t stretched_value(const Slanted& slanted,
                        const SlantedLeaf& leaf,
                        const PointQ8& at) {
  FieldTerms terms;
  terms.count = static_cast<uint8_t>(leaf.count);
  terms.op = leaf.op;
  for (uint32_t i = 0; i < leaf.count; ++i) {
    set_up_term(terms.term[i], slanted.field, leaf.units[i], at.x, at.y,
                slanted.scale);
  }
  stretch_terms(slanted.brush, slanted.far_q22, terms);
  return with_sign(
      combine_q22(terms, slanted.scale.bend_log2, slanted.reach_q22),
      leaf.sign);
}

void draw_slanted_row(Slanted& slanted,
                      RowPoint at,
                      int32_t x,
                      int32_t count) noexcept {
  const GlyphField& field = slanted.field;
  const GlyphStep& right = slanted.brush.right();
  const uint32_t wide_q8 =
      slanted.has_short_steps() ? kMinWide << 18 : UINT32_MAX;
  const int32_t end = x + count;
  while (x < end) {
    const Leaf found = find_leaf(field, at.x_q16 >> 16, at.y_q16 >> 16);
    const uint32_t square_log2 = 16 + found.size_log2;
    SlantedLeaf leaf;
    leaf.count = 0;
    if (found.reference >= format::glyph::kFirstNode) {
      read_leaf(field, found.reference, leaf);
    }
    if (leaf.count != 0 && slanted.scale.size_q8 << found.size_log2 < wide_q8) {
      slanted.writer.begin(x);
      uint32_t change = 0;
      do {
        slanted.writer.append(coverage_at(slanted, leaf, at), ++x);
        const uint32_t x_q16 = at.x_q16;
        const uint32_t y_q16 = at.y_q16;
        at.go(right);
        change = (at.x_q16 ^ x_q16) | (at.y_q16 ^ y_q16);
      } while (x < end && change >> square_log2 == 0);
      continue;
    }
    uint32_t steps = slanted.across.steps_in_square(
        at.x_q16, square_log2, static_cast<uint32_t>(end - x - 1));
    steps = slanted.up.steps_in_square(at.y_q16, square_log2, steps);
    Side side = found.reference == format::glyph::kInside ? Side::inside
                                                          : Side::outside;
    if (leaf.count != 0) {
      side = Side::edge;
      if (steps + 1 >= kMinRun) {
        steps = lesser(steps, kMaxRun - 1);
        side = side_of_run(slanted, leaf, at, steps);
      }
    }
    const auto count_here = static_cast<int32_t>(steps + 1);
    if (side != Side::edge) {
      slanted.writer.saturated(x, count_here, side == Side::inside);
    } else {
      draw_pixels(slanted, leaf, at, x, x + count_here);
    }
    x += count_here;
    at.x_q16 += times(right.x_q16, steps + 1);
    at.y_q16 += times(right.y_q16, steps + 1);
    at.x_q20 += times(right.x_q20, steps + 1);
    at.y_q20 += times(right.y_q20, steps + 1);
  }
}

}  // namespace detail
}  // namespace inkcell
