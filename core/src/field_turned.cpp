// Slanted rows of cells.
//
// Along a row a leaf is kept while points stay in its square, which a few bits
// of two neighbours tell. Saturated leaves take no more than that. In others a
// pixel is evaluated no further than to the first field that decides it; only
// where a vertex may be near, or edges are stretched, are terms set up.
// fields_distance_q10 and stretched_fields_q10 give the same coverage bit by
// bit.
#include "field_turned.hpp"

#include "cell_access.hpp"
#include "position.hpp"
#include "span_writer.hpp"

namespace inkcell {
namespace detail {
namespace {

// Where a pixel's centre lies, in u from the grid's corner and in px.
struct RowPoint {
  uint32_t x_q16;
  uint32_t y_q16;
  uint32_t x_q20;
  uint32_t y_q20;

  void go(const GlyphStep& step) noexcept {
    x_q16 += static_cast<uint32_t>(step.x_q16);
    y_q16 += static_cast<uint32_t>(step.y_q16);
    x_q20 += static_cast<uint32_t>(step.x_q20);
    y_q20 += static_cast<uint32_t>(step.y_q20);
  }
};

using StretchTerms = void (*)(const Brush&, int32_t, FieldTerms&);

// What a glyph's pixels have in common.
struct Slanted {
  const GlyphField& field;
  const Brush& brush;
  StretchTerms stretch;  // null: edges are stretched alike
  int32_t reach_q22;
  int32_t far_q22;  // fields' values from here on decide
  FieldScale scale;
  // The limits of what may show, from the grid's corner.
  uint32_t left_q16;
  uint32_t low_q16;
  uint32_t width_q16;
  uint32_t height_q16;
  SpanWriter writer;

  Slanted(const GlyphField& glyph,
          const Brush& its_brush,
          StretchTerms its_stretch,
          const Sink& sink,
          int32_t y) noexcept
      : field(glyph),
        brush(its_brush),
        stretch(its_stretch),
        reach_q22(reach_of(its_brush.filter())),
        far_q22(reach_q22),
        scale(scale_of(its_brush)),
        writer(sink, y) {
    const Rect limits = limits_of(field, brush);
    const auto side = [](int32_t low, int32_t high) noexcept {
      return low < high ? static_cast<uint32_t>(high - low) << 16 : 0;
    };
    left_q16 = side(field.x0_u, limits.x0);
    low_q16 = side(field.y0_u, limits.y0);
    width_q16 = side(limits.x0, limits.x1);
    height_q16 = side(limits.y0, limits.y1);
  }

  bool may_show(const RowPoint& at) const noexcept {
    return at.x_q16 - left_q16 < width_q16 && at.y_q16 - low_q16 < height_q16;
  }
};

// The fields of a leaf. With `sign` -1 all values are negated, so that there is
// only the least.
struct SlantedLeaf {
  uint16_t units[3];
  FieldOperator op;
  uint32_t count;
  int32_t sign;
};

// A point to evaluate. [px, Q8]
struct PointQ8 {
  uint32_t x;
  uint32_t y;
};

int32_t with_sign(int32_t value, int32_t sign) noexcept {
  return wrapped(static_cast<uint32_t>(value ^ sign) -
                 static_cast<uint32_t>(sign));
}

// The plain way, negated if the leaf is.
__attribute__((noinline)) int32_t stretched(const Slanted& slanted,
                                            const SlantedLeaf& leaf,
                                            const PointQ8& at) noexcept {
  FieldTerms terms;
  terms.count = static_cast<uint8_t>(leaf.count);
  terms.op = leaf.op;
  for (uint32_t i = 0; i < leaf.count; ++i) {
    set_up_term(terms.term[i], slanted.field, leaf.units[i], at.x, at.y,
                slanted.scale);
  }
  slanted.stretch(slanted.brush, slanted.far_q22, terms);
  return with_sign(
      combine_q22(terms, slanted.scale.bend_log2, slanted.reach_q22),
      leaf.sign);
}

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
  FieldTerm lesser;
  FieldTerm greater;
  set_up_term(lesser, slanted.field, leaf.units[i], at.x, at.y, slanted.scale);
  set_up_term(greater, slanted.field, leaf.units[j], at.x, at.y, slanted.scale);
  return rounded_q22(values[i], lesser, values[j], greater,
                     slanted.scale.bend_log2);
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
    return stretched(slanted, leaf, at);
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
             ? stretched(slanted, leaf, at)
             : least;
}

uint32_t magnitude(int32_t value) noexcept {
  const auto plain = static_cast<uint32_t>(value);
  return value < 0 ? 0u - plain : plain;
}

// Pixels are taken for alike up to this many at once.
constexpr uint32_t kMostAlike = 32;

// How many pixels from here on are surely as saturated as this one, from how
// far the fields are and how fast they change along the row. 0: not known.
__attribute__((noinline)) uint32_t count_alike(const Slanted& slanted,
                                               const SlantedLeaf& leaf,
                                               const PointQ8& at) noexcept {
  constexpr uint32_t kFar = 1u << 30;     // from here on values may wrap
  constexpr uint32_t kMargin = 1u << 20;  // more than all roundings
  const GlyphStep& right = slanted.brush.right();
  const int32_t bend_log2 = slanted.scale.bend_log2;
  if ((magnitude(right.x_q20) | magnitude(right.y_q20)) >= 1u << 21) {
    return 0;
  }
  int32_t values[3] = {};
  uint32_t steepest_q14 = 0;  // change of a value from pixel to pixel
  for (uint32_t i = 0; i < leaf.count; ++i) {
    FieldTerm term;
    set_up_term(term, slanted.field, leaf.units[i], at.x, at.y, slanted.scale);
    values[i] = with_sign(term.value_q22(bend_log2), leaf.sign);
    const uint32_t sum_q14 = magnitude(term.nx_q14) + magnitude(term.ny_q14);
    uint32_t slope_q14 = (magnitude(term.nx_q14 * (right.x_q20 >> 7) +
                                    term.ny_q14 * (right.y_q20 >> 7)) >>
                          13) +
                         1;
    if (term.bend != 0) {
      // A step is less than 4 px long. Nothing wraps while w stays below 256 px
      // and the slope that the bend adds below 1.
      const uint32_t along_q8 =
          magnitude(term.along_q8()) + kMostAlike * (sum_q14 >> 5);
      const uint32_t bend = magnitude(term.bend);
      if (along_q8 >= 1u << 16 || (bend >> 4) * along_q8 >= 1u << 27) {
        return 0;
      }
      const uint32_t added_q14 = (bend * along_q8) >> (bend_log2 + 5);
      if (added_q14 >= 1u << 14) {
        return 0;
      }
      slope_q14 +=
          (added_q14 * sum_q14) >> (slanted.stretch != nullptr ? 12 : 14);
    }
    if (magnitude(values[i]) >= kFar) {
      return 0;
    }
    steepest_q14 = slope_q14 > steepest_q14 ? slope_q14 : steepest_q14;
  }
  int32_t least = values[0];
  if (leaf.op >= FieldOperator::least_of_greater) {
    const int32_t inner = values[1] > values[2] ? values[1] : values[2];
    least = least < inner ? least : inner;
  } else {
    for (uint32_t i = 1; i < leaf.count; ++i) {
      least = least < values[i] ? least : values[i];
    }
  }
  const uint32_t away = magnitude(least);
  const uint32_t sure = static_cast<uint32_t>(slanted.far_q22) + kMargin;
  if (away <= sure || steepest_q14 > 1u << 15) {
    return 0;
  }
  const uint32_t room = away - sure;
  uint32_t count = room >> 23;
  if (steepest_q14 <= 1u << 13) {
    count = room >> 21;
  } else if (steepest_q14 <= 9u << 11) {
    count = (room - (room >> 3)) >> 22;  // 7/8 of 9/8 is less than 1
  }
  return count < kMostAlike ? count : kMostAlike;
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

// Pixels are skipped in cells that are so wide, so far from edges. [px]
constexpr uint32_t kMinLarge = 8;
constexpr uint32_t kMinAway = 3;

// Draws a row from `at`, where it may show, to where it may no more.
__attribute__((noinline)) void draw_fields_row(Slanted& slanted,
                                               RowPoint& at,
                                               int32_t x,
                                               int32_t end) noexcept {
  const GlyphField& field = slanted.field;
  const GlyphStep& right = slanted.brush.right();
  const Filter& filter = slanted.brush.filter();
  const uint32_t far_enough =
      static_cast<uint32_t>(slanted.far_q22) + (kMinAway << 22);
  bool may_show = true;
  // To the next pixel, if it lies in the same square.
  const auto go = [&](uint32_t square_log2) noexcept {
    const RowPoint last = at;
    at.go(right);
    may_show = ++x < end && slanted.may_show(at);
    const uint32_t change = (at.x_q16 ^ last.x_q16) | (at.y_q16 ^ last.y_q16);
    return may_show && change >> square_log2 == 0;
  };
  while (may_show) {
    const Leaf found = find_leaf(field, at.x_q16 >> 16, at.y_q16 >> 16);
    const uint32_t square_log2 = 16 + found.size_log2;
    SlantedLeaf leaf;
    leaf.count = 0;
    if (found.reference >= format::glyph::kFirstNode) {
      read_leaf(field, found.reference, leaf);
    }
    if (leaf.count == 0) {
      const int32_t first = x;
      while (go(square_log2)) {
      }
      slanted.writer.saturated(first, x - first,
                               found.reference == format::glyph::kInside);
      continue;
    }
    const bool is_large = slanted.scale.size_q8 << found.size_log2 >= kMinLarge
                                                                          << 18;
    slanted.writer.begin(x);
    while (true) {
      const PointQ8 point = {q8_of(at.x_q20), q8_of(at.y_q20)};
      const int32_t value_q22 =
          with_sign(leaf.count == 3 ? triple_at(slanted, leaf, point)
                                    : pair_at(slanted, leaf, point),
                    leaf.sign);
      if (is_large && magnitude(value_q22) >= far_enough) {
        const int32_t first = x;
        uint32_t alike = count_alike(slanted, leaf, point);
        bool stays = go(square_log2);
        for (; stays && alike > 0; --alike) {
          stays = go(square_log2);
        }
        slanted.writer.saturated(first, x - first, value_q22 > 0);
        if (!stays) {
          break;
        }
        slanted.writer.begin(x);
        continue;
      }
      slanted.writer.append(filter.coverage(value_q22 >> 12), x + 1);
      if (!go(square_log2)) {
        break;
      }
    }
  }
}

FieldPosition position_in(const GlyphField& field,
                          const RowPoint& at) noexcept {
  return {wrapped(at.x_q16) + field.x0_u * (1 << 16),
          wrapped(at.y_q16) + field.y0_u * (1 << 16), 0, 0};
}

// The same for cells of samples, which are quartic along a row: every pixel is
// a query of its own.
void draw_turned_samples(Slanted& slanted,
                         RowPoint& at,
                         int32_t x,
                         int32_t end) noexcept {
  const Brush& brush = slanted.brush;
  do {
    const FieldPosition place = position_in(slanted.field, at);
    slanted.writer.put(x, brush.coverage(samples_distance_q10(
                              slanted.field, place.x_q16, place.y_q16)));
    at.go(brush.right());
  } while (++x < end && slanted.may_show(at));
}

void draw_stretched_samples(Slanted& slanted,
                            RowPoint& at,
                            int32_t x,
                            int32_t end) noexcept {
  const Brush& brush = slanted.brush;
  do {
    const FieldPosition place = position_in(slanted.field, at);
    const int32_t plain =
        samples_distance_q10(slanted.field, place.x_q16, place.y_q16);
    uint8_t coverage = 0;
    if (brush.is_opaque(plain)) {
      coverage = 255;
    } else if (!brush.is_transparent(plain)) {
      coverage = brush.filter().coverage(
          stretched_samples_q10(slanted.field, brush, place));
    }
    slanted.writer.put(x, coverage);
    at.go(brush.right());
  } while (++x < end && slanted.may_show(at));
}

// From the grid's corner, modulo 2^16 u.
RowPoint point_of(const GlyphField& field, const GlyphWay& way) noexcept {
  return {static_cast<uint32_t>(way.x_q16) -
              static_cast<uint32_t>(field.x0_u * (1 << 16)),
          static_cast<uint32_t>(way.y_q16) -
              static_cast<uint32_t>(field.y0_u * (1 << 16)),
          way.x_q20, way.y_q20};
}

// Whether a place is so near that it cannot be taken for one in the grid.
bool is_near(const GlyphWay& way) noexcept {
  return clamp_i32(way.x_q16) == way.x_q16 && clamp_i32(way.y_q16) == way.y_q16;
}

// Whether all of a box is. Turned grids always are; of a stretched one the
// corners may be far away.
bool is_near(const Brush& brush,
             const FinePoint& origin,
             const Rect& box) noexcept {
  const int32_t columns[] = {box.x0, box.x1};
  const int32_t rows[] = {box.y0, box.y1};
  for (const int32_t x : columns) {
    for (const int32_t y : rows) {
      if (!is_near(GlyphWay(brush, ScreenWay(origin, x, y)))) {
        return false;
      }
    }
  }
  return true;
}

using DrawRow = void (*)(Slanted&, RowPoint&, int32_t, int32_t);

// Every pixel for itself.
__attribute__((noinline)) void paint_far(Slanted& slanted,
                                         const FinePoint& origin,
                                         const Rect& box,
                                         DrawRow draw_row) noexcept {
  for (int32_t y = box.y0; y < box.y1; ++y) {
    for (int32_t x = box.x0; x < box.x1; ++x) {
      const GlyphWay way(slanted.brush, ScreenWay(origin, x, y));
      RowPoint at = point_of(slanted.field, way);
      if (is_near(way) && slanted.may_show(at)) {
        draw_row(slanted, at, x, x + 1);
      }
    }
    slanted.writer.next_row();
  }
}

void paint(Slanted& slanted,
           const FinePoint& origin,
           const Rect& box,
           DrawRow draw_row) noexcept {
  const Brush& brush = slanted.brush;
  const GlyphStep& right = brush.right();
  const GlyphStep& up = brush.up();
  if (slanted.stretch != nullptr && !is_near(brush, origin, box)) {
    paint_far(slanted, origin, box, draw_row);
    return;
  }
  RowPoint start = point_of(slanted.field,
                            GlyphWay(brush, ScreenWay(origin, box.x0, box.y0)));
  for (int32_t y = box.y0; y < box.y1; ++y) {
    RowPoint at = start;
    int32_t x = box.x0;
    while (x < box.x1 && !slanted.may_show(at)) {
      at.x_q16 += static_cast<uint32_t>(right.x_q16);
      at.y_q16 += static_cast<uint32_t>(right.y_q16);
      ++x;
    }
    if (x < box.x1) {
      const auto before = static_cast<uint32_t>(x - box.x0);
      at.x_q20 += times(right.x_q20, before);
      at.y_q20 += times(right.y_q20, before);
      draw_row(slanted, at, x, box.x1);
    }
    slanted.writer.next_row();
    start.x_q16 -= static_cast<uint32_t>(up.x_q16);
    start.y_q16 -= static_cast<uint32_t>(up.y_q16);
    start.x_q20 -= static_cast<uint32_t>(up.x_q20);
    start.y_q20 -= static_cast<uint32_t>(up.y_q20);
  }
}

}  // namespace

void paint_turned(const GlyphField& field,
                  const Brush& brush,
                  const void*,
                  const FinePoint& origin,
                  const RowMap*,
                  const Sink& sink) noexcept {
  const Rect box = intersect(field_box(field, brush, origin), sink.window);
  if (!is_empty(box)) {
    Slanted slanted(field, brush, nullptr, sink, box.y0);
    paint(slanted, origin, box,
          has_fields(field) ? draw_fields_row : draw_turned_samples);
  }
}

void paint_stretched(const GlyphField& field,
                     const Brush& brush,
                     const void*,
                     const FinePoint& origin,
                     const RowMap*,
                     const Sink& sink) noexcept {
  const Rect box = intersect(field_box(field, brush, origin), sink.window);
  if (!is_empty(box)) {
    Slanted slanted(field, brush, stretch_terms, sink, box.y0);
    slanted.far_q22 = far_q22(brush, slanted.reach_q22);
    paint(slanted, origin, box,
          has_fields(field) ? draw_fields_row : draw_stretched_samples);
  }
}

}  // namespace detail
}  // namespace inkcell
