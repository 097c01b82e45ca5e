// Slanted rows of cells.
//
// A row meets the limits of what may show in one stretch of pixels. Its ends
// move from row to row, and are found by walking from those of the row above:
// that takes no division, and as many steps in all as the glyph is wide.
//
// Along the stretch a leaf is kept while points stay in its square, which a few
// bits of two neighbours tell. Saturated leaves take no more than that. In
// others a pixel is evaluated no further than to the first field that decides
// it; only where a vertex may be near, or edges are stretched, are terms set up
// for combine_q22. fields_distance_q10 and stretched_fields_q10 give the same
// coverage bit by bit.
#include "field_turned.hpp"

#include "cell_access.hpp"
#include "position.hpp"
#include "span_writer.hpp"

namespace inkcell {
namespace detail {
namespace {

// One coordinate of pixels in the glyph, mirrored if it falls to the right: so
// that along a row all before the limits come first and all beyond them last.
// [u, Q16]
struct Axis {
  int32_t mirror;  // -1, else 0
  int32_t step;    // to the right: 0 or more
  int32_t down;    // to the row below
  int32_t low;     // within the limits: low <= at < high
  int32_t high;

  Axis(int32_t right, int32_t up, int32_t low_u, int32_t high_u) noexcept
      : mirror(right < 0 ? -1 : 0),
        step((right ^ mirror) - mirror),
        down(-((up ^ mirror) - mirror)),
        low((mirror != 0 ? -high_u : low_u) * (1 << 16)),
        high((mirror != 0 ? -low_u : high_u) * (1 << 16)) {}
};

// A pixel of each row, and where it lies along the axes.
struct RowEnd {
  int32_t x;
  int64_t across;
  int64_t up;
};

struct Axes {
  Axis across;
  Axis up;

  // Whether a pixel is not before the limits, and whether it is beyond them:
  // along a row both change once at the most.
  bool is_in(const RowEnd& at) const noexcept {
    return at.across >= across.low && at.up >= up.low;
  }
  bool is_out(const RowEnd& at) const noexcept {
    return at.across >= across.high || at.up >= up.high;
  }
  void go(RowEnd& at, int32_t pixels) const noexcept {
    at.x += pixels;
    at.across += pixels * across.step;
    at.up += pixels * up.step;
  }
  // From the pixel above to the first one of the row that is in, or out.
  void find(RowEnd& at, const Rect& box, bool out) const noexcept {
    at.across += across.down;
    at.up += up.down;
    const auto has_come = [&] { return out ? is_out(at) : is_in(at); };
    while (at.x < box.x1 && !has_come()) {
      go(at, 1);
    }
    while (at.x > box.x0) {
      go(at, -1);
      if (!has_come()) {
        go(at, 1);
        return;
      }
    }
  }
};

using StretchTerms = void (*)(const Brush&, int32_t, FieldTerms&);

// What a glyph's pixels have in common.
struct Slanted {
  const GlyphField& field;
  const Brush& brush;
  FieldScale scale;
  int32_t reach_q22;
  int32_t far_q22;       // fields' values from here on decide
  StretchTerms stretch;  // null: edges are stretched alike
  SpanWriter writer;
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

// The plain way.
__attribute__((noinline)) int32_t combined(const Slanted& slanted,
                                           const SlantedLeaf& leaf,
                                           PointQ8 at) noexcept {
  FieldTerms terms;
  terms.count = static_cast<uint8_t>(leaf.count);
  terms.op = leaf.op;
  for (uint32_t i = 0; i < leaf.count; ++i) {
    set_up_term(terms.term[i], slanted.field, leaf.units[i], at.x, at.y,
                slanted.scale);
  }
  if (slanted.stretch != nullptr) {
    slanted.stretch(slanted.brush, slanted.far_q22, terms);
  }
  return combine_q22(terms, slanted.scale.bend_log2, slanted.reach_q22);
}

inline int32_t value_at(const Slanted& slanted,
                        const SlantedLeaf& leaf,
                        uint32_t i,
                        PointQ8 at) noexcept {
  FieldTerm term;
  set_up_term(term, slanted.field, leaf.units[i], at.x, at.y, slanted.scale);
  return with_sign(term.value_q22(slanted.scale.bend_log2), leaf.sign);
}

// The distance of three fields, or what is as far on the same side.
__attribute__((noinline)) int32_t triple_at(const Slanted& slanted,
                                            const SlantedLeaf& leaf,
                                            PointQ8 at) noexcept {
  const int32_t first = value_at(slanted, leaf, 0, at);
  int32_t least = first;
  if (least > -slanted.far_q22) {
    const int32_t second = value_at(slanted, leaf, 1, at);
    const int32_t third = value_at(slanted, leaf, 2, at);
    const bool is_nested = leaf.op >= FieldOperator::least_of_greater;
    least = min_of(least,
                   is_nested ? max_of(second, third) : min_of(second, third));
  }
  if (least < slanted.far_q22 && least > -slanted.far_q22) {
    return combined(slanted, leaf, at);
  }
  return with_sign(least, leaf.sign);
}

// The same of one or two.
inline int32_t pair_at(const Slanted& slanted,
                       const SlantedLeaf& leaf,
                       PointQ8 at) noexcept {
  const int32_t far = slanted.far_q22;
  int32_t least = value_at(slanted, leaf, 0, at);
  if (leaf.count == 2 && least > -far) {
    const int32_t first = least;
    const int32_t second = value_at(slanted, leaf, 1, at);
    least = min_of(first, second);
    // Where the greater one is farther from 0 no vertex is near.
    if (least < 0 && least > -far && first + second < 0) {
      return combined(slanted, leaf, at);
    }
  }
  if (slanted.stretch != nullptr && least < far && least > -far) {
    return combined(slanted, leaf, at);
  }
  return with_sign(least, leaf.sign);
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

// A point of a row, from the grid's corner, and how it goes on.
struct RowPoint {
  uint32_t x_q16;
  uint32_t y_q16;
  uint32_t x_q20;
  uint32_t y_q20;

  // To the next pixel. Whether that lies in the same square.
  bool go(const GlyphStep& right, uint32_t square_log2) noexcept {
    const uint32_t x = x_q16 + static_cast<uint32_t>(right.x_q16);
    const uint32_t y = y_q16 + static_cast<uint32_t>(right.y_q16);
    const uint32_t change = (x ^ x_q16) | (y ^ y_q16);
    x_q16 = x;
    y_q16 = y;
    x_q20 += static_cast<uint32_t>(right.x_q20);
    y_q20 += static_cast<uint32_t>(right.y_q20);
    return change >> square_log2 == 0;
  }
};

__attribute__((noinline)) void draw_fields_row(Slanted& slanted,
                                               RowPoint at,
                                               Range pixels) noexcept {
  const GlyphField& field = slanted.field;
  const GlyphStep right = slanted.brush.right();
  const Filter& filter = slanted.brush.filter();
  int32_t x = pixels.begin;
  while (x < pixels.end) {
    const Leaf found = find_leaf(field, at.x_q16 >> 16, at.y_q16 >> 16);
    const uint32_t square_log2 = 16 + found.size_log2;
    SlantedLeaf leaf;
    leaf.count = 0;
    if (found.reference >= format::glyph::kFirstNode) {
      read_leaf(field, found.reference, leaf);
    }
    if (leaf.count == 0) {
      const int32_t first = x;
      do {
        ++x;
      } while (at.go(right, square_log2) && x < pixels.end);
      slanted.writer.saturated(first, x - first,
                               found.reference == format::glyph::kInside);
      continue;
    }
    slanted.writer.begin(x);
    do {
      const PointQ8 point = {q8_of(at.x_q20), q8_of(at.y_q20)};
      const int32_t value_q22 = leaf.count == 3
                                    ? triple_at(slanted, leaf, point)
                                    : pair_at(slanted, leaf, point);
      ++x;
      slanted.writer.append(filter.coverage(value_q22 >> 12), x);
    } while (at.go(right, square_log2) && x < pixels.end);
  }
}

// Cells of samples are quartic along a row: every pixel is a query of its own.
using SamplesCoverage = uint8_t (*)(const GlyphField&,
                                    const Brush&,
                                    const FieldPosition&);

uint8_t turned_coverage(const GlyphField& field,
                        const Brush& brush,
                        const FieldPosition& at) noexcept {
  return brush.coverage(samples_distance_q10(field, at.x_q16, at.y_q16));
}

uint8_t stretched_coverage(const GlyphField& field,
                           const Brush& brush,
                           const FieldPosition& at) noexcept {
  const int32_t plain = samples_distance_q10(field, at.x_q16, at.y_q16);
  if (brush.is_transparent(plain)) {
    return 0;
  }
  if (brush.is_opaque(plain)) {
    return 255;
  }
  return brush.filter().coverage(stretched_samples_q10(field, brush, at));
}

__attribute__((noinline)) void draw_samples_row(Slanted& slanted,
                                                FieldPosition at,
                                                Range pixels,
                                                SamplesCoverage coverage) {
  const GlyphStep& right = slanted.brush.right();
  for (int32_t x = pixels.begin; x < pixels.end; ++x) {
    slanted.writer.put(x, coverage(slanted.field, slanted.brush, at));
    at.x_q16 += right.x_q16;
    at.y_q16 += right.y_q16;
  }
}

void paint(Slanted& slanted,
           const FinePoint& origin,
           const Rect& box,
           SamplesCoverage samples_coverage) noexcept {
  const GlyphField& field = slanted.field;
  const Brush& brush = slanted.brush;
  const GlyphStep& right = brush.right();
  const GlyphStep& up = brush.up();
  const Rect limits = limits_of(field, brush);
  const Axes axes = {{right.x_q16, up.x_q16, limits.x0, limits.x1},
                     {right.y_q16, up.y_q16, limits.y0, limits.y1}};
  // A row above the first one.
  const GlyphWay way(brush, ScreenWay(origin, box.x0, box.y0 - 1));
  RowEnd begin = {box.x0, way.x_q16 ^ axes.across.mirror,
                  way.y_q16 ^ axes.up.mirror};
  RowEnd end = begin;
  uint32_t x_q20 = way.x_q20;
  uint32_t y_q20 = way.y_q20;
  for (int32_t y = box.y0; y < box.y1; ++y) {
    axes.find(begin, box, false);
    axes.find(end, box, true);
    x_q20 -= static_cast<uint32_t>(up.x_q20);
    y_q20 -= static_cast<uint32_t>(up.y_q20);
    if (begin.x < end.x) {
      const auto x_q16 =
          static_cast<int32_t>(begin.across ^ axes.across.mirror);
      const auto y_q16 = static_cast<int32_t>(begin.up ^ axes.up.mirror);
      const auto before = static_cast<uint32_t>(begin.x - box.x0);
      const Range pixels = {begin.x, end.x};
      if (has_fields(field)) {
        draw_fields_row(slanted,
                        {static_cast<uint32_t>(x_q16 - field.x0_u * (1 << 16)),
                         static_cast<uint32_t>(y_q16 - field.y0_u * (1 << 16)),
                         x_q20 + times(right.x_q20, before),
                         y_q20 + times(right.y_q20, before)},
                        pixels);
      } else {
        draw_samples_row(slanted, {x_q16, y_q16, 0, 0}, pixels,
                         samples_coverage);
      }
    }
    slanted.writer.next_row();
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
    const int32_t reach_q22 = reach_of(brush.filter());
    Slanted slanted = {field,     brush,   scale_of(brush),         reach_q22,
                       reach_q22, nullptr, SpanWriter(sink, box.y0)};
    paint(slanted, origin, box, turned_coverage);
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
    const int32_t reach_q22 = reach_of(brush.filter());
    Slanted slanted = {field,
                       brush,
                       scale_of(brush),
                       reach_q22,
                       far_q22(brush, reach_q22),
                       stretch_terms,
                       SpanWriter(sink, box.y0)};
    paint(slanted, origin, box, stretched_coverage);
  }
}

}  // namespace detail
}  // namespace inkcell
