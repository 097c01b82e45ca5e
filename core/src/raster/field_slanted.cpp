// Slanted glyphs of fields, in bands of rows.
//
// A leaf is a rectangle that leans. It is met at a point that nothing was drawn
// at, and followed from row to row:
//
//        . . a a . .      row 0 finds a at its third point,
//        . a a a a .      row 1 begins a point further left,
//        a a a a . .      row 2, too, and ends further left.
//
// If a row does not touch the one above, the leaf may be met again. Its fields
// are set up once and evaluated at each point for itself: fields_distance_q10
// and stretched_fields_q10 give the same coverage bit by bit.
#include "raster/field_slanted.hpp"

#include "distance/field_terms.hpp"
#include "distance/point_terms.hpp"
#include "raster/field_turned.hpp"
#include "raster/leaf_band.hpp"

namespace inkcell {
namespace detail {
namespace {

// One field along a row.
struct OneAt : Pen {
  ArcAt a;

  __attribute__((always_inline)) OneAt(const Pen& pen,
                                       const FieldLeaves& leaves,
                                       const FieldLeaf& leaf) noexcept
      : Pen(pen), a(leaf.field[0], leaves.scale(), 0) {}

  __attribute__((always_inline)) int32_t value(const FieldLeaves& leaves,
                                               FieldLeaf&,
                                               uint32_t) const noexcept {
    return a.value(place(), leaves.bend_shift(), 0);
  }
};

// Tells where a point lies that may be near a vertex: first in a row of its
// own.
struct PlaceHere {
  FieldLeaf& leaf;
  const PixelPlace& at;

  __attribute__((always_inline)) uint32_t operator()() const noexcept {
    leaf.place = at;
    return 0;
  }
};

// Two fields, or three.
template <typename Fields>
struct SomeAt : Pen, Fields {
  __attribute__((always_inline)) SomeAt(const Pen& pen,
                                        const FieldLeaves& leaves,
                                        const FieldLeaf& leaf) noexcept
      : Pen(pen), Fields(leaf, leaves.scale()) {}

  __attribute__((always_inline)) int32_t value(const FieldLeaves& leaves,
                                               FieldLeaf& leaf,
                                               uint32_t) const noexcept {
    const PixelPlace at = place();
    return this->combined(leaves, leaf, PlaceHere{leaf, at}, at);
  }
};

// Any number of fields.
struct AllAt : Pen {
  int32_t sign;
  uint32_t count;
  ArcAt field[3];

  AllAt(const Pen& pen,
        const FieldLeaves& leaves,
        const FieldLeaf& leaf) noexcept
      : Pen(pen), sign(leaf.sign), count(leaf.count) {
    for (uint32_t i = 0; i < count; ++i) {
      field[i] = ArcAt(leaf.field[i], leaves.scale(), sign);
    }
  }

  int32_t value(const FieldLeaves& leaves,
                FieldLeaf& leaf,
                uint32_t) const noexcept {
    const PixelPlace at = place();
    // Two are three of which one is never the least.
    int32_t values[3] = {0, 0, INT32_MAX};
    for (uint32_t i = 0; i < count; ++i) {
      values[i] = field[i].value(at, leaves.bend_shift(), sign);
    }
    const int32_t least =
        count == 1 ? values[0]
                   : leaves.least_of_three(leaf, values[0], values[1],
                                           values[2], PlaceHere{leaf, at});
    return with_sign(least, sign);
  }
};

// What is stretched, whatever it is.
struct StretchedAt : Pen {
  const Stretching& stretching;

  StretchedAt(const Pen& pen, const Stretching& its_stretching) noexcept
      : Pen(pen), stretching(its_stretching) {}

  int32_t value(const FieldLeaves& leaves,
                const FieldLeaf& leaf,
                uint32_t) const noexcept {
    return stretching.value(stretching, leaves, leaf, place());
  }
};

// The number of the lowest bit of those that are set.
inline int32_t lowest_bit(uint32_t bits) noexcept {
  // Each product's upper 5 bits are others: a sequence of de Bruijn.
  static constexpr uint8_t kNumbers[32] = {
      0,  1,  28, 2,  29, 14, 24, 3, 30, 22, 20, 15, 25, 17, 4,  8,
      31, 27, 13, 23, 21, 19, 16, 7, 26, 12, 18, 6,  11, 5,  10, 9};
  return kNumbers[((bits & (0u - bits)) * 0x077cb531u) >> 27];
}

// The bits from a number on, before another one up to 31.
inline uint32_t bits_between(int32_t begin, int32_t end) noexcept {
  return (1u << end) - (1u << begin);
}

// In cells that are so wide rows are measured, and fields asked whether they
// matter: of upright cells (kMinReduced) it takes a little less. [px]
constexpr uint32_t kMinWide = 6;

// Larger cells are not: px from side to side would pass 32 bits. None keeps the
// format's limits. [log2 u]
constexpr uint8_t kMostReduced = 10;

// The points of a row that lie in a leaf, all in a rectangle of the glyph. [u,
// Q16]
struct LeafRow {
  uint32_t across;  // how large the rectangle is
  uint32_t high;
  uint32_t x;  // of the first point, from the rectangle's corner
  uint32_t y;
  int32_t begin;
  int32_t end;

  __attribute__((always_inline)) bool holds(uint32_t at_x,
                                            uint32_t at_y) const noexcept {
    return at_x < across && at_y < high;
  }
  // Moves the end as far as points lie in the rectangle; the last one does, and
  // lies here.
  __attribute__((always_inline)) void stretch(const GlyphStep& right,
                                              uint32_t at_x,
                                              uint32_t at_y,
                                              int32_t most) noexcept {
    while (end != most) {
      at_x += static_cast<uint32_t>(right.x_q16);
      at_y += static_cast<uint32_t>(right.y_q16);
      if (!holds(at_x, at_y)) {
        break;
      }
      ++end;
    }
  }
  // To the row below. False: no point of it below those of this row lies in the
  // rectangle.
  __attribute__((always_inline)) bool go_down(const GlyphStep& right,
                                              const GlyphStep& up,
                                              int32_t width) noexcept {
    x -= static_cast<uint32_t>(up.x_q16);
    y -= static_cast<uint32_t>(up.y_q16);
    if (!find_begin(right)) {
      return false;
    }
    find_end(right, width);
    return true;
  }

 private:
  __attribute__((always_inline)) bool find_begin(
      const GlyphStep& right) noexcept {
    const auto step_x = static_cast<uint32_t>(right.x_q16);
    const auto step_y = static_cast<uint32_t>(right.y_q16);
    if (holds(x, y)) {
      while (begin != 0 && holds(x - step_x, y - step_y)) {
        x -= step_x;
        y -= step_y;
        --begin;
      }
      return true;
    }
    do {
      x += step_x;
      y += step_y;
      ++begin;
    } while (begin != end && !holds(x, y));
    return begin != end;
  }
  __attribute__((always_inline)) void find_end(const GlyphStep& right,
                                               int32_t width) noexcept {
    const auto last = static_cast<uint32_t>(end - 1 - begin);
    uint32_t end_x = x + times(right.x_q16, last);
    uint32_t end_y = y + times(right.y_q16, last);
    if (holds(end_x, end_y)) {
      stretch(right, end_x, end_y, width);
      return;
    }
    do {
      end_x -= static_cast<uint32_t>(right.x_q16);
      end_y -= static_cast<uint32_t>(right.y_q16);
      --end;
    } while (!holds(end_x, end_y));
  }
};

// Draws bands of points that are a style's step apart.
class SlantedBand : public LeafBand {
 public:
  SlantedBand(const Slanted& slanted, const Stretching* stretching) noexcept
      : LeafBand(slanted.field,
                 scale_of(slanted.style),
                 slanted.style.filter(),
                 stretching == nullptr ? reach_of(slanted.style.filter())
                                       : stretching->far_q22),
        slanted_(slanted),
        stretching_(stretching) {
    if (stretching != nullptr) {
      set_far(-stretching->far_q22, stretching->far_q22);
    }
    const GlyphStep& right = slanted.style.right();
    // Steps of less than 2 px along each axis of the glyph, and distances that
    // leave room for sums.
    constexpr int32_t kLimit = 1 << 21;
    may_reduce_ = reach_q22_ < 1 << 29 && right.x_q20 < kLimit &&
                  right.x_q20 > -kLimit && right.y_q20 < kLimit &&
                  right.y_q20 > -kLimit;
  }

  // The coverage of its points. False: it is 0 everywhere.
  bool cover(const SlantedPoint& first,
             int32_t width,
             int32_t height,
             Pixels& pixels) const noexcept;

 private:
  // Points of a row.
  struct Span {
    uint8_t begin;
    uint8_t end;
  };
  struct SlantedLeaf : BandLeaf {
    Span spans[kRows];
  };

  uint32_t size_q18(const FieldLeaf& leaf) const noexcept {
    return scale_.size_q8 << leaf.size_log2;
  }
  void follow(SlantedLeaf& leaf,
              uint32_t x_q16,
              uint32_t y_q16,
              int32_t width,
              int32_t height,
              uint32_t* todo) const noexcept;
  void reduce_at(SlantedLeaf& leaf, const SlantedPoint& at) const noexcept;
  void paint_leaf(SlantedLeaf& leaf, const SlantedPoint& at) const noexcept;
  template <typename Terms>
  void paint(Terms& terms, SlantedLeaf& leaf) const noexcept;
  template <typename Terms>
  void paint_as(SlantedLeaf& leaf, const SlantedPoint& at) const noexcept;
  void paint_stretched(SlantedLeaf& leaf,
                       const SlantedPoint& at) const noexcept;

  const Slanted& slanted_;
  const Stretching* stretching_;
  bool may_reduce_;
};

// Sets the points of a leaf, row by row, given the first one. Those that show
// nothing for sure are not among them.
__attribute__((noinline)) void SlantedBand::follow(
    SlantedLeaf& leaf,
    uint32_t x_q16,
    uint32_t y_q16,
    int32_t width,
    int32_t height,
    uint32_t* todo) const noexcept {
  const GlyphStep& right = slanted_.style.right();
  const GlyphStep& up = slanted_.style.up();
  // The part of the square that may show.
  const uint32_t mask = (1u << (leaf.size_log2 + 16)) - 1;
  const auto meet = [mask](uint32_t place, uint32_t low, uint32_t length,
                           uint32_t& at) noexcept {
    const uint32_t way = place - low;
    at = min(place & mask, way);
    return at + min(~place & mask, length - 1 - way) + 1;
  };
  const Window& limits = slanted_.limits;
  LeafRow row;
  row.across = meet(x_q16, limits.left_q16, limits.width_q16, row.x);
  row.high = meet(y_q16, limits.low_q16, limits.height_q16, row.y);
  row.begin = leaf.spans[0].begin;
  if (size_q18(leaf) >= kMinWide << 18) {
    const uint32_t steps = slanted_.across.steps_within(
        row.x, row.across, static_cast<uint32_t>(width - 1 - row.begin));
    row.end =
        row.begin + 1 +
        static_cast<int32_t>(slanted_.up.steps_within(row.y, row.high, steps));
  } else {
    row.end = row.begin + 1;
    row.stretch(right, row.x, row.y, width);
  }
  int32_t rows = 0;
  do {
    leaf.spans[rows] = {static_cast<uint8_t>(row.begin),
                        static_cast<uint8_t>(row.end)};
    todo[rows] &= ~bits_between(row.begin, row.end);
  } while (++rows != height && row.go_down(right, up, width));
  leaf.height = static_cast<uint8_t>(rows);
}

// What matters of a leaf in the box around its points, as far as that lies in
// its square.
__attribute__((noinline)) void SlantedBand::reduce_at(
    SlantedLeaf& leaf, const SlantedPoint& at) const noexcept {
  int32_t begin = kColumns;
  int32_t end = 0;
  for (int32_t row = 0; row < leaf.height; ++row) {
    begin = min(begin, leaf.spans[row].begin);
    end = max(end, leaf.spans[row].end);
  }
  // From the first point, `at`.
  const int32_t first = begin - leaf.spans[0].begin;
  const int32_t last = end - 1 - leaf.spans[0].begin;
  const int32_t down = leaf.height - 1;
  const uint32_t mask = (1u << (leaf.size_log2 + 16)) - 1;
  const auto px_q8 = [this](uint32_t way_q16) noexcept {
    return static_cast<int32_t>(((way_q16 >> 10) * (scale_.size_q8 >> 2)) >>
                                14);
  };
  // More than what is cut off.
  constexpr int32_t kMargin = 8;
  const auto meet = [&](uint32_t place_q16, uint32_t place_q20,
                        int32_t right_q20, int32_t up_q20, uint32_t& middle_q8,
                        uint32_t& half_q8) noexcept {
    const int32_t right_q12 = right_q20 >> 8;
    const int32_t down_q12 = -down * (up_q20 >> 8);
    const int32_t low_q12 =
        min(right_q12 * first, right_q12 * last) + min(down_q12, int32_t{0});
    const int32_t high_q12 =
        max(right_q12 * first, right_q12 * last) + max(down_q12, int32_t{0});
    const int32_t low = max((low_q12 >> 4), -px_q8(place_q16 & mask)) - kMargin;
    const int32_t high =
        min((high_q12 >> 4), px_q8(~place_q16 & mask)) + kMargin;
    middle_q8 = q8_of(place_q20) + static_cast<uint32_t>((low + high) >> 1);
    half_q8 = static_cast<uint32_t>((high - low + 1) >> 1);
  };
  const GlyphStep& right = slanted_.style.right();
  const GlyphStep& up = slanted_.style.up();
  Extent all;
  meet(at.x_q16, at.x_q20, right.x_q20, up.x_q20, all.middle.x_q8,
       all.half_x_q8);
  meet(at.y_q16, at.y_q20, right.y_q20, up.y_q20, all.middle.y_q8,
       all.half_y_q8);
  all.sign = leaf.sign;
  all.right = &right;
  constexpr uint32_t kMostHalf = 64 << 8;
  if (all.half_x_q8 < kMostHalf && all.half_y_q8 < kMostHalf) {
    reduce(leaf, all);
  }
}

template <typename Terms>
__attribute__((always_inline)) inline void SlantedBand::paint(
    Terms& terms, SlantedLeaf& leaf) const noexcept {
  uint8_t* line = leaf.line;
  const Span* span = leaf.spans;
  for (int32_t rows = leaf.height;; ++span) {
    const uint8_t* const out =
        paint_row(terms, leaf, line, line + (span->end - span->begin));
    if (--rows == 0) {
      return;
    }
    const int32_t shift = span[1].begin - span->begin;
    terms.go_on(static_cast<uint32_t>(line - out + shift));
    terms.go_down(slanted_.style);
    line += kColumns + shift;
  }
}

// Not inline: the loops have the registers for themselves.
template <typename Terms>
__attribute__((noinline)) void SlantedBand::paint_as(
    SlantedLeaf& leaf, const SlantedPoint& at) const noexcept {
  Terms terms(Pen(slanted_.style, at.x_q20, at.y_q20), *this, leaf);
  paint(terms, leaf);
}

inline void SlantedBand::paint_leaf(SlantedLeaf& leaf,
                                    const SlantedPoint& at) const noexcept {
  if (leaf.count == 0) {
    uint8_t* line = leaf.line - leaf.spans[0].begin;
    for (int32_t row = 0; row < leaf.height; ++row, line += kColumns) {
      const Span& span = leaf.spans[row];
      fill(line + span.begin, span.end - span.begin);
    }
    return;
  }
  if (stretching_ != nullptr) {
    paint_stretched(leaf, at);
  } else if constexpr (!kFastRows) {
    paint_as<AllAt>(leaf, at);
  } else if (leaf.count == 1) {
    // Lines, too: a loop of their own is 1 % faster at 96 px, for 340 bytes.
    paint_as<OneAt>(leaf, at);
  } else if (leaf.count == 2) {
    if (leaf.has_lines(2)) {
      paint_as<SomeAt<TwoFields<LineAt>>>(leaf, at);
    } else {
      paint_as<SomeAt<TwoFields<ArcAt>>>(leaf, at);
    }
  } else if (leaf.has_lines(3)) {
    paint_as<SomeAt<ThreeFields<LineAt>>>(leaf, at);
  } else {
    paint_as<SomeAt<ThreeFields<ArcAt>>>(leaf, at);
  }
}

__attribute__((noinline)) void SlantedBand::paint_stretched(
    SlantedLeaf& leaf, const SlantedPoint& at) const noexcept {
  StretchedAt stretched(Pen(slanted_.style, at.x_q20, at.y_q20), *stretching_);
  paint(stretched, leaf);
}

// Not inline: its leaf is off the stack when rows are handed on.
__attribute__((noinline)) bool SlantedBand::cover(
    const SlantedPoint& first,
    int32_t width,
    int32_t height,
    Pixels& pixels) const noexcept {
  const TextStyle& style = slanted_.style;
  pixels.clear(height);
  uint32_t todo[kRows];
  for (int32_t y = 0; y < height; ++y) {
    todo[y] = bits_between(0, width);
  }
  const GlyphStep& right = style.right();
  bool any = false;
  SlantedPoint row = first;
  for (int32_t y = 0; y < height; ++y) {
    while (todo[y] != 0) {
      const int32_t x = lowest_bit(todo[y]);
      const auto before = static_cast<uint32_t>(x);
      const uint32_t x_q16 = row.x_q16 + times(right.x_q16, before);
      const uint32_t y_q16 = row.y_q16 + times(right.y_q16, before);
      if (!slanted_.limits.holds(x_q16, y_q16)) {
        // Once a row has left what may show it does not come back.
        todo[y] = x != 0 ? 0
                         : todo[y] & ~bits_between(0, slanted_.count_before(
                                                          x_q16, y_q16, width));
        continue;
      }
      SlantedLeaf leaf;
      find_leaf(x_q16 >> 16, y_q16 >> 16, leaf);
      leaf.spans[0].begin = static_cast<uint8_t>(x);
      follow(leaf, x_q16, y_q16, width, height - y, todo + y);
      if (leaf.count == 0 && !leaf.is_inside) {
        continue;
      }
      const SlantedPoint at = {x_q16, y_q16,
                               row.x_q20 + times(right.x_q20, before),
                               row.y_q20 + times(right.y_q20, before)};
      leaf.line = pixels.row(y) + x;
      leaf.know_nothing();
      if (may_reduce_ && leaf.count != 0 && leaf.size_log2 <= kMostReduced &&
          size_q18(leaf) >= kMinWide << 18) {
        reduce_at(leaf, at);
      }
      if (leaf.count != 0 || leaf.is_inside) {
        any = true;
        paint_leaf(leaf, at);
      }
    }
    row.go(style.up(), UINT32_MAX);
  }
  return any;
}

}  // namespace

int32_t stretched_value(const Stretching& stretching,
                        const FieldLeaves& leaves,
                        const FieldLeaf& leaf,
                        const PixelPlace& at) {
  const int32_t bend_shift = leaves.scale().bend_shift;
  const int32_t far_q22 = stretching.far_q22;
  const int32_t sign = leaf.sign;
  FieldTerms terms;
  terms.count = leaf.count;
  terms.op = leaf.field_operator();
  // What decides without stretching: a field that is far outside, or all that
  // are far inside.
  int32_t least_q22 = INT32_MAX;
  for (uint32_t i = 0; i < leaf.count; ++i) {
    FieldTerm& term = terms.term[i];
    const uint8_t* const field = leaf.field[i];
    set_up_term(term, field - arc_bit(field), arc_bit(field) != 0, at.x_q8,
                at.y_q8, leaves.scale());
    const int32_t value_q22 = with_sign(term.value_q22(bend_shift), sign);
    if (value_q22 <= -far_q22 && (i == 0 || !leaf.is_nested)) {
      return with_sign(value_q22, sign);
    }
    least_q22 = min(least_q22, value_q22);
  }
  if (least_q22 >= far_q22) {
    return with_sign(least_q22, sign);
  }
  stretch_terms(stretching.style, far_q22, terms);
  const int32_t value_q22 =
      combine_q22(terms, bend_shift, stretching.reach_q22);
  return min(max(value_q22, -far_q22), far_q22);
}

void draw_slanted(const Slanted& slanted,
                  const Stretching* stretching,
                  SlantedPoint first,
                  const Rect& box,
                  const Sink& sink) noexcept {
  const SlantedBand band(slanted, stretching);
  const GlyphStep& right = slanted.style.right();
  const GlyphStep& up = slanted.style.up();
  int32_t rows;
  for (int32_t y = box.y0; y < box.y1; y += rows) {
    rows = LeafBand::rows_of(box.y1 - y);
    int32_t count;
    for (int32_t x = box.x0; x < box.x1; x += count) {
      LeafBand::Pixels lines;
      count = min(box.x1 - x, LeafBand::kColumns);
      if (band.cover(first, count, rows, lines)) {
        for (int32_t row = 0; row < rows; ++row) {
          sink.coverage(sink.context, x, y + row, lines.row(row), count);
        }
      }
      first.go(right, static_cast<uint32_t>(count));
    }
    first.go(right, static_cast<uint32_t>(box.x0 - box.x1));
    first.go(up, 0u - static_cast<uint32_t>(rows));
  }
}

}  // namespace detail
}  // namespace inkcell
