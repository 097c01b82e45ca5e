// Rows of cells of fields, fast.
//
// A cell's share of a row is a run. In short ones each pixel is evaluated for
// itself, and no further than to the first field that decides it. In others a
// field is set up once, for x = 0, from where its value at any pixel takes one
// product, two more if it is bent. Fields that cannot change coverage, because
// they stay beyond the filter's ramp from end to end, are then dropped or
// decide all of the run. Everything is exact modulo 2^32, so that no pixel
// depends on where a run begins.
#include "field_draw.hpp"

#include "cell_access.hpp"

namespace inkcell {
namespace detail {
namespace {

// What pixels show: nothing, all, or what their distances say.
enum class Side : int8_t { outside = -1, edge = 0, inside = 1 };

// Runs are cut after this many pixels: a plane, of slope 2 at most, cannot wrap
// from one side to the other unseen.
constexpr int32_t kMaxRun = 128;

// Shorter runs are drawn pixel by pixel.
constexpr int32_t kMinLong = 4;

// In shorter ones no pixels are skipped.
constexpr int32_t kMinSkipped = 16;

// LongRun::slope_q14 where values may change by any amount, and its log2.
constexpr int32_t kNoSlope = INT32_MAX;
constexpr uint32_t kNoSkip = 31;

int32_t magnitude(int32_t value) noexcept {
  return value < 0 ? -value : value;
}

int32_t greater(int32_t a, int32_t b) noexcept {
  return a > b ? a : b;
}

// From a nearer distance than this, 256 px, nothing wraps within a run.
bool is_far(int32_t value_q22) noexcept {
  constexpr int32_t kFar = 1 << 30;
  return value_q22 >= kFar || value_q22 <= -kFar;
}

// A bent field between two pixels of a row.
struct Arc {
  // It differs from the chord by no more, roundings included. [Q22]
  int32_t sag_q22;
  int32_t slope_q14;  // nor changes by more in a pixel [px]
};

// `term` is set up for x = 0. False if something may wrap, and nothing is
// known.
__attribute__((noinline)) bool bound_arc(const FieldTerm& term,
                                         uint32_t first_q8,
                                         uint32_t last_q8,
                                         int32_t bend_log2,
                                         Arc& arc) noexcept {
  const FieldTerm first = term.moved(first_q8);
  const FieldTerm last = term.moved(last_q8);
  const int32_t along_q8 =
      greater(magnitude(first.along_q8()), magnitude(last.along_q8()));
  const int32_t first_slope = first.slope_q15(bend_log2);
  const int32_t last_slope = last.slope_q15(bend_log2);
  const int32_t steepest =
      greater(magnitude(first_slope), magnitude(last_slope));
  // Nothing wraps from one end to the other: w stays below 256 px and k w below
  // 1.
  if (along_q8 >= 1 << 16 || steepest >= 1 << 15 ||
      magnitude(term.bend >> 4) * along_q8 >= 1 << 27) {
    return false;
  }
  // A parabola stays within a quarter of the change of its slope times the way
  // along it, k (dw)^2 / 4, of the chord. Roundings take less than 1/16.
  const int32_t ny_q14 = magnitude(term.ny_q14);
  const auto change =
      static_cast<uint32_t>(magnitude(last_slope - first_slope));
  const uint32_t way_q8 =
      (static_cast<uint32_t>(ny_q14) * ((last_q8 - first_q8) >> 8)) >> 6;
  arc.sag_q22 = static_cast<int32_t>((change * way_q8) >> 3) + (1 << 18);
  // Half the slope in Q15 is all of it in Q14.
  arc.slope_q14 = magnitude(term.nx_q14) + ((steepest * ny_q14) >> 14) + 1;
  return true;
}

// -value if `sign` is -1, value if it is 0; may wrap.
int32_t with_sign(int32_t value, int32_t sign) noexcept {
  return wrapped(static_cast<uint32_t>(value ^ sign) -
                 static_cast<uint32_t>(sign));
}

// What a glyph's rows have in common, and the row.
struct Row {
  const GlyphField& field;
  const Filter& filter;
  FieldScale scale;
  int32_t reach_q22;
  int32_t step_q16;
  uint32_t y_q8;
  SpanWriter writer;
};

// The fields of a leaf. With `sign` -1 all values are negated, so that there is
// only the least.
struct LeafFields {
  uint16_t units[3];
  bool is_nested;
  uint32_t count;
  int32_t sign;
};

// The value of one field at a pixel.
__attribute__((always_inline)) inline int32_t value_at(const Row& row,
                                                       uint32_t unit,
                                                       uint32_t x_q8) noexcept {
  FieldTerm term;
  set_up_term(term, row.field, unit, x_q8, row.y_q8, row.scale);
  return term.value_q22(row.scale.bend_log2);
}

// The lesser of the values of fields i and j, rounded at their vertex: what is
// rarely needed is set up again.
__attribute__((noinline)) int32_t rounded_at(const Row& row,
                                             const LeafFields& leaf,
                                             uint32_t i,
                                             uint32_t j,
                                             const int32_t* values,
                                             uint32_t x_q8) noexcept {
  FieldTerm lesser;
  FieldTerm greater;
  set_up_term(lesser, row.field, leaf.units[i], x_q8, row.y_q8, row.scale);
  set_up_term(greater, row.field, leaf.units[j], x_q8, row.y_q8, row.scale);
  return rounded_q22(values[i], lesser, values[j], greater,
                     row.scale.bend_log2);
}

// The lesser of two values, rounded where that changes coverage.
inline int32_t least_of(const Row& row,
                        const LeafFields& leaf,
                        uint32_t i,
                        uint32_t j,
                        const int32_t* values,
                        uint32_t x_q8) noexcept {
  if (values[i] > values[j]) {
    const uint32_t other = i;
    i = j;
    j = other;
  }
  const int32_t lesser = values[i];
  // Where the greater one is farther from 0 no vertex is near.
  if (lesser < 0 && lesser > -row.reach_q22 && lesser + values[j] < 0) {
    return rounded_at(row, leaf, i, j, values, x_q8);
  }
  return lesser;
}

// The distance of a leaf of two or three fields from their values, which may be
// changed.
__attribute__((noinline)) int32_t combined(const Row& row,
                                           const LeafFields& leaf,
                                           int32_t* values,
                                           uint32_t x_q8) noexcept {
  uint32_t first = 0;
  uint32_t second = 1;
  if (leaf.is_nested) {
    values[1] = with_sign(values[1], -1);
    values[2] = with_sign(values[2], -1);
    const int32_t inner =
        with_sign(least_of(row, leaf, 1, 2, values, x_q8), -1);
    second = values[1] <= values[2] ? 1 : 2;
    values[second] = inner;
  } else if (leaf.count == 3) {
    if (values[0] > values[1] && values[0] > values[2]) {
      first = 1;  // without the greatest
      second = 2;
    } else if (values[1] > values[2]) {
      second = 2;
    }
  }
  return least_of(row, leaf, first, second, values, x_q8);
}

// The distance of one pixel of a leaf of several fields, or what is as far on
// the same side.
__attribute__((noinline)) int32_t several_at(const Row& row,
                                             const LeafFields& leaf,
                                             uint32_t x_q8) noexcept {
  int32_t values[3];
  for (uint32_t i = 0; i < leaf.count; ++i) {
    values[i] = with_sign(value_at(row, leaf.units[i], x_q8), leaf.sign);
    if (values[i] <= -row.reach_q22 && (i == 0 || !leaf.is_nested)) {
      return with_sign(values[i], leaf.sign);
    }
  }
  return with_sign(combined(row, leaf, values, x_q8), leaf.sign);
}

// The same of two fields, which are frequent.
inline int32_t pair_at(const Row& row,
                       const LeafFields& leaf,
                       uint32_t x_q8) noexcept {
  int32_t values[2];
  values[0] = with_sign(value_at(row, leaf.units[0], x_q8), leaf.sign);
  int32_t least = values[0];
  if (least > -row.reach_q22) {
    values[1] = with_sign(value_at(row, leaf.units[1], x_q8), leaf.sign);
    const bool in_order = least <= values[1];
    least = in_order ? least : values[1];
    // Where the greater one is farther from 0 no vertex is near.
    if (least < 0 && least > -row.reach_q22 && values[0] + values[1] < 0) {
      least = rounded_at(row, leaf, in_order ? 0 : 1, in_order ? 1 : 0, values,
                         x_q8);
    }
  }
  return with_sign(least, leaf.sign);
}

// Pixels of a leaf, one by one, from `x_q16` to before `end_q16`. How many.
inline int32_t draw_pixels(Row& row,
                           const LeafFields& leaf,
                           int32_t x,
                           uint32_t x_q8,
                           int32_t x_q16,
                           int32_t end_q16) noexcept {
  const int32_t first = x;
  row.writer.begin(x);
  do {
    const int32_t value_q22 = leaf.count == 1
                                  ? value_at(row, leaf.units[0], x_q8)
                              : leaf.count == 2 ? pair_at(row, leaf, x_q8)
                                                : several_at(row, leaf, x_q8);
    ++x;
    row.writer.append(row.filter.coverage(value_q22 >> 12), x);
    x_q8 += 1 << 8;
    x_q16 += row.step_q16;
  } while (x_q16 < end_q16);
  return x - first;
}

// How many pixels lie before a place `way_q16` further on, the first of them at
// 0; `most` or kMaxRun at the most. [u]
inline int32_t pixels_before(const Row& row,
                             int32_t way_q16,
                             int32_t most) noexcept {
  most = most < kMaxRun ? most : kMaxRun;
  // A guess that is not too high, from a px being 65536 u / size. Beyond 256 u,
  // where it would wrap, it stops.
  int32_t way_q6 = way_q16 >> 10;
  way_q6 = way_q6 < 256 << 6 ? way_q6 : (256 << 6) - 1;
  const auto size_q6 = static_cast<int32_t>(row.scale.size_q8 >> 2);
  int32_t count = (way_q6 * size_q6) >> 22;
  count = count < most ? count : most;
  for (int32_t at = count * row.step_q16; count < most && at < way_q16;
       at += row.step_q16) {
    ++count;
  }
  return count;
}

// Many pixels of a leaf. Fields that cannot change them are dropped, and with
// them most runs that show no edge.
struct LongRun {
  const Row& row;
  int32_t count;
  uint32_t x_q8;
  // No field changes by more in a pixel; kNoSlope if one may by any amount.
  int32_t slope_q14;
  // The fields that are left, at x = 0, and their values at x_q8, negated if
  // the leaf's are.
  LeafFields& leaf;
  FieldTerm terms[3];
  int32_t values_q22[3];

  LongRun(const Row& the_row,
          LeafFields& the_leaf,
          uint32_t first_q8,
          int32_t pixels) noexcept
      : row(the_row),
        count(pixels),
        x_q8(first_q8),
        slope_q14(0),
        leaf(the_leaf) {}

  Side set_up_term(uint32_t unit) noexcept;
  Side set_up() noexcept;
  Side set_up_nested() noexcept;
  void go_to(uint32_t to_q8) noexcept;
  uint32_t skip_log2() const noexcept;
  int32_t least_q22() const noexcept;
};

// Sets up a field behind those that are left. What it shows of the run.
inline Side LongRun::set_up_term(uint32_t unit) noexcept {
  const int32_t reach_q22 = row.reach_q22;
  const int32_t bend_log2 = row.scale.bend_log2;
  FieldTerm& term = terms[leaf.count];
  detail::set_up_term(term, row.field, unit, 0, row.y_q8, row.scale);
  leaf.units[leaf.count] = static_cast<uint16_t>(unit);
  const int32_t first_q22 = term.moved(x_q8).value_q22(bend_log2);
  values_q22[leaf.count] = with_sign(first_q22, leaf.sign);
  const bool is_beyond = first_q22 >= reach_q22 || first_q22 <= -reach_q22;
  int32_t slope = is_far(first_q22) ? kNoSlope : magnitude(term.nx_q14);
  if (is_beyond || (term.bend != 0 && count >= kMinSkipped)) {
    const uint32_t last_q8 = x_q8 + (static_cast<uint32_t>(count - 1) << 8);
    const int32_t last_q22 = term.moved(last_q8).value_q22(bend_log2);
    int32_t beyond_q22 = reach_q22;
    if (term.bend != 0) {
      Arc arc = {0, kNoSlope};
      if (is_far(first_q22) || is_far(last_q22) ||
          !bound_arc(term, x_q8, last_q8, bend_log2, arc)) {
        slope_q14 = kNoSlope;
        return Side::edge;
      }
      beyond_q22 += arc.sag_q22;
      slope = arc.slope_q14;
    }
    if (first_q22 >= beyond_q22 && last_q22 >= beyond_q22) {
      return leaf.sign == 0 ? Side::inside : Side::outside;
    }
    if (first_q22 <= -beyond_q22 && last_q22 <= -beyond_q22) {
      return leaf.sign == 0 ? Side::outside : Side::inside;
    }
  } else if (term.bend != 0) {
    slope = kNoSlope;
  }
  slope_q14 = greater(slope, slope_q14);
  return Side::edge;
}

// What all fields show, as if the operator asked for the least; if that is an
// edge, at least one field is left.
inline Side LongRun::set_up() noexcept {
  const uint32_t all = leaf.count;
  leaf.count = 0;
  if (leaf.is_nested) {
    return set_up_nested();
  }
  for (uint32_t i = 0; i < all; ++i) {
    const Side side = set_up_term(leaf.units[i]);
    if (side == Side::outside) {
      return Side::outside;
    }
    if (side == Side::edge) {
      ++leaf.count;
    }
  }
  return leaf.count == 0 ? Side::inside : Side::edge;
}

// The same where the first field meets the greater of the other two.
Side LongRun::set_up_nested() noexcept {
  Side sides[3];
  for (uint32_t i = 0; i < 3; ++i) {
    sides[i] = set_up_term(leaf.units[i]);
    if (sides[i] == Side::edge) {
      ++leaf.count;
    }
  }
  const bool is_first_left = sides[0] == Side::edge;
  if (sides[0] == Side::outside ||
      (sides[1] == Side::outside && sides[2] == Side::outside)) {
    return Side::outside;
  }
  if (sides[1] == Side::inside || sides[2] == Side::inside) {
    leaf.count = is_first_left ? 1 : 0;
  }
  if (leaf.count == 0) {
    return Side::inside;
  }
  leaf.is_nested = leaf.count == 3;
  if (!leaf.is_nested && !is_first_left) {
    // The greater of the others is all.
    leaf.sign = ~leaf.sign;
    for (uint32_t i = 0; i < leaf.count; ++i) {
      values_q22[i] = with_sign(values_q22[i], -1);
    }
  }
  return Side::edge;
}

inline void LongRun::go_to(uint32_t to_q8) noexcept {
  x_q8 = to_q8;
  for (uint32_t i = 0; i < leaf.count; ++i) {
    values_q22[i] = with_sign(
        terms[i].moved(to_q8).value_q22(row.scale.bend_log2), leaf.sign);
  }
}

// By how much values may change in a pixel. The least of several changes no
// faster than each of them, but what is rounded may jump. [log2, Q22]
inline uint32_t LongRun::skip_log2() const noexcept {
  if (leaf.is_nested || slope_q14 > 1 << 15) {
    return kNoSkip;
  }
  uint32_t log2 = 23;
  while (log2 > 18 && slope_q14 <= 1 << (log2 - 9)) {
    --log2;
  }
  return log2;
}

// The least value, without rounding.
inline int32_t LongRun::least_q22() const noexcept {
  int32_t least = values_q22[0];
  for (uint32_t i = 1; i < leaf.count; ++i) {
    least = values_q22[i] < least ? values_q22[i] : least;
  }
  return least;
}

// All pixels of a run whose fields are set up.
inline void draw_every(Row& row, LongRun& run, int32_t x) noexcept {
  const LeafFields& leaf = run.leaf;
  const int32_t end = x + run.count;
  uint32_t x_q8 = run.x_q8;
  row.writer.begin(x);
  if (leaf.count == 1) {
    const FieldTerm term = run.terms[0];
    do {
      const int32_t value_q22 = term.moved(x_q8).value_q22(row.scale.bend_log2);
      row.writer.append(row.filter.coverage(value_q22 >> 12), ++x);
      x_q8 += 1 << 8;
    } while (x < end);
    return;
  }
  while (true) {
    const int32_t value_q22 = combined(row, leaf, run.values_q22, run.x_q8);
    row.writer.append(
        row.filter.coverage(with_sign(value_q22, leaf.sign) >> 12), ++x);
    if (x == end) {
      return;
    }
    run.go_to(run.x_q8 + (1 << 8));
  }
}

// Draws `count` pixels of a leaf.
__attribute__((noinline)) void draw_long_run(Row& row,
                                             LeafFields& leaf,
                                             int32_t x,
                                             uint32_t x_q8,
                                             int32_t count) noexcept {
  // Roundings of bent fields do not reach so far.
  constexpr int32_t kMargin = 1 << 20;
  LongRun run(row, leaf, x_q8, count);
  const Side side = run.set_up();
  if (side != Side::edge) {
    row.writer.saturated(x, count, (side == Side::inside) == (leaf.sign == 0));
    return;
  }
  if (count < kMinSkipped) {
    draw_every(row, run, x);
    return;
  }
  const uint32_t skip_log2 = run.skip_log2();
  const int32_t end = x + count;
  while (true) {
    int32_t value_q22 = leaf.is_nested
                            ? combined(row, leaf, run.values_q22, run.x_q8)
                            : run.least_q22();
    int32_t step = 1;
    if (value_q22 >= row.reach_q22 || value_q22 <= -row.reach_q22) {
      const uint32_t away = value_q22 < 0
                                ? 0u - static_cast<uint32_t>(value_q22)
                                : static_cast<uint32_t>(value_q22);
      const uint32_t sure = static_cast<uint32_t>(row.reach_q22 + kMargin);
      const uint32_t room = static_cast<uint32_t>(end - x);
      const uint32_t same = away > sure ? ((away - sure) >> skip_log2) + 1 : 1;
      step = static_cast<int32_t>(same < room ? same : room);
      row.writer.saturated(x, step, (value_q22 > 0) == (leaf.sign == 0));
    } else {
      if (leaf.count > 1 && !leaf.is_nested) {
        value_q22 = combined(row, leaf, run.values_q22, run.x_q8);
      }
      row.writer.put(
          x, row.filter.coverage(with_sign(value_q22, leaf.sign) >> 12));
    }
    x += step;
    if (x >= end) {
      return;
    }
    run.go_to(run.x_q8 + (static_cast<uint32_t>(step) << 8));
  }
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
                      LeafFields& leaf) noexcept {
  FieldOperator op = FieldOperator::least;
  leaf.count = field.kind == GlyphField::Kind::narrow_fields
                   ? read_narrow_leaf(field, reference, leaf.units, op)
                   : read_linked_leaf(field, reference, leaf.units, op);
  leaf.sign = -(static_cast<int32_t>(op) & 1);
  leaf.is_nested = op >= FieldOperator::least_of_greater;
}

// Draws a row of the grid; `x_q16` is from its left edge, `y` in u from its
// lower one.
inline void draw_row(
    Row& row, Range pixels, uint32_t x_q8, int32_t x_q16, uint32_t y) noexcept {
  const GlyphField& field = row.field;
  const int32_t end_q16 =
      x_q16 + (pixels.end - pixels.begin - 1) * row.step_q16 + 1;
  int32_t x = pixels.begin;
  while (x_q16 < end_q16) {
    const Leaf found = find_leaf(field, static_cast<uint32_t>(x_q16) >> 16, y);
    const uint32_t size_log2 = 16 + found.size_log2;
    const int32_t right_q16 = ((x_q16 >> size_log2) + 1) << size_log2;
    int32_t count = 0;
    LeafFields leaf;
    leaf.count = 0;
    if (found.reference >= format::glyph::kFirstNode) {
      read_leaf(field, found.reference, leaf);
    }
    if (leaf.count != 0 && right_q16 - x_q16 < row.step_q16 * kMinLong) {
      count = draw_pixels(row, leaf, x, x_q8, x_q16,
                          right_q16 < end_q16 ? right_q16 : end_q16);
    } else {
      count = pixels_before(row, right_q16 - x_q16, pixels.end - x);
      if (leaf.count != 0) {
        draw_long_run(row, leaf, x, x_q8, count);
      } else {
        row.writer.saturated(x, count,
                             found.reference == format::glyph::kInside);
      }
    }
    x += count;
    x_q16 += count * row.step_q16;
    x_q8 += static_cast<uint32_t>(count) << 8;
  }
}

}  // namespace

void draw_fields(const GlyphField& field,
                 const Brush& brush,
                 Upright& upright,
                 const Sink& sink) noexcept {
  const Rect& pixels = upright.pixels;
  Row row = {field,
             brush.filter(),
             scale_of(brush),
             reach_of(brush.filter()),
             brush.step_along_q16(),
             0,
             SpanWriter(sink, pixels.y0)};
  for (int32_t y = pixels.y0; y < pixels.y1; ++y) {
    FieldPosition at;
    if (upright.place_row(brush, at)) {
      row.y_q8 = q8_of(at.y_q20);
      draw_row(row, {pixels.x0, pixels.x1}, q8_of(at.x_q20),
               at.x_q16 - field.x0_u * (1 << 16),
               static_cast<uint32_t>(at.y_q16 - field.y0_u * (1 << 16)) >> 16);
    }
    row.writer.next_row();
    upright.next_row(brush);
  }
}

int32_t fields_distance_q10(const GlyphField& field,
                            const Brush& brush,
                            const FieldPosition& at,
                            int32_t reach_q22) noexcept {
  const int32_t x_u = at.x_q16 >> 16;
  const int32_t y_u = at.y_q16 >> 16;
  Cell cell;
  if (in_grid(field, x_u, y_u)) {
    cell = locate_fields(field, x_u, y_u);
  }
  if (cell.field_count == 0) {
    return brush.to_px_q10(cell.inside ? kSaturatedDistanceQ10
                                       : -kSaturatedDistanceQ10);
  }
  FieldTerms terms;
  set_up_terms(terms, field, cell, q8_of(at.x_q20), q8_of(at.y_q20),
               scale_of(brush));
  return combine_q22(terms, brush.bend_log2(), reach_q22) >> 12;
}

}  // namespace detail
}  // namespace inkcell
