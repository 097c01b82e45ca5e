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
#include "field_slanted.hpp"

#include "field_band.hpp"
#include "field_turned.hpp"

namespace inkcell {
namespace detail {
namespace {

// A line at any point, with the leaf's sign.
struct LineAt {
  int32_t nx_q14;
  int32_t ny_q14;
  uint32_t offset_q22;

  LineAt() = default;

  __attribute__((always_inline)) LineAt(const uint8_t* record,
                                        const FieldScale& scale,
                                        int32_t sign) noexcept {
    namespace layout = format::fields;
    nx_q14 = with_sign(load_i16(record + layout::kNormalX), sign);
    ny_q14 = with_sign(load_i16(record + layout::kNormalY), sign);
    offset_q22 = times(with_sign(load_i16(record + layout::kOffset), sign),
                       scale.size_q8);
  }

  __attribute__((always_inline)) uint32_t plane_q22(
      const PixelPlace& at) const noexcept {
    return times(nx_q14, at.x_q8) + times(ny_q14, at.y_q8) + offset_q22;
  }
  __attribute__((always_inline)) int32_t value(const PixelPlace& at,
                                               int32_t,
                                               int32_t) const noexcept {
    return wrapped(plane_q22(at));
  }
};

// The same of an arc, or of a line that is treated like one.
struct ArcAt {
  LineAt plane;
  uint32_t along_q22;  // of the origin; it and `bend` as in FieldTerm
  int32_t bend;

  ArcAt() = default;
  __attribute__((always_inline))
  ArcAt(const uint8_t* field, const FieldScale& scale, int32_t) noexcept
      : plane(field - arc_bit(field), scale, 0), along_q22(0), bend(0) {
    namespace layout = format::fields;
    if (arc_bit(field) != 0) {
      const uint8_t* const record = field - 1;
      along_q22 =
          (1 << 13) + times(load_i16(record + layout::kAlong), scale.size_q8);
      bend =
          (load_i16(record + layout::kBend) * scale.bend_q14 + (1 << 10)) >> 11;
    }
  }

  __attribute__((always_inline)) int32_t value(const PixelPlace& at,
                                               int32_t bend_shift,
                                               int32_t sign) const noexcept {
    const auto along_q8 =
        static_cast<uint32_t>(wrapped(along_q22 + times(plane.nx_q14, at.y_q8) -
                                      times(plane.ny_q14, at.x_q8)) >>
                              14);
    const int32_t slope_q15 = wrapped(times(bend, along_q8)) >> bend_shift;
    const int32_t sag_q22 = wrapped(times(slope_q15, along_q8)) >> 1;
    return with_sign(
        wrapped(plane.plane_q22(at) + static_cast<uint32_t>(sag_q22)), sign);
  }
};

// A point that goes along the rows of a leaf.
class Pen {
 public:
  Pen(const Brush& brush, const SlantedPoint& at) noexcept
      : x_q20_(at.x_q20),
        y_q20_(at.y_q20),
        right_x_q20_(static_cast<uint32_t>(brush.right().x_q20)),
        right_y_q20_(static_cast<uint32_t>(brush.right().y_q20)) {}

  __attribute__((always_inline)) PixelPlace place() const noexcept {
    return {q8_of(x_q20_), q8_of(y_q20_)};
  }
  __attribute__((always_inline)) void go_on(uint32_t count) noexcept {
    x_q20_ += count * right_x_q20_;
    y_q20_ += count * right_y_q20_;
  }
  void go_down(const Brush& brush) noexcept {
    x_q20_ -= static_cast<uint32_t>(brush.up().x_q20);
    y_q20_ -= static_cast<uint32_t>(brush.up().y_q20);
  }

 private:
  uint32_t x_q20_;
  uint32_t y_q20_;
  uint32_t right_x_q20_;
  uint32_t right_y_q20_;
};

// One field along a row.
template <typename Field>
struct OneAt : Pen {
  Field a;

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

// Two fields.
template <typename Field>
struct TwoAt : Pen {
  int32_t sign;
  Field a;
  Field b;

  __attribute__((always_inline)) TwoAt(const Pen& pen,
                                       const FieldLeaves& leaves,
                                       const FieldLeaf& leaf) noexcept
      : Pen(pen),
        sign(leaf.sign),
        a(leaf.field[0], leaves.scale(), sign),
        b(leaf.field[1], leaves.scale(), sign) {}

  __attribute__((always_inline)) int32_t value(const FieldLeaves& leaves,
                                               FieldLeaf& leaf,
                                               uint32_t) const noexcept {
    const PixelPlace at = place();
    const int32_t shift = leaves.bend_shift();
    const auto number = [&leaf, &at ]() __attribute__((always_inline)) {
      leaf.place = at;
      return uint32_t{0};
    };
    return with_sign(leaves.least_of_two(leaf, a.value(at, shift, sign),
                                         b.value(at, shift, sign), number),
                     sign);
  }
};

// Three fields.
template <typename Field>
struct ThreeAt : Pen {
  int32_t sign;
  Field a;
  Field b;
  Field c;

  __attribute__((always_inline)) ThreeAt(const Pen& pen,
                                         const FieldLeaves& leaves,
                                         const FieldLeaf& leaf) noexcept
      : Pen(pen),
        sign(leaf.sign),
        a(leaf.field[0], leaves.scale(), sign),
        b(leaf.field[1], leaves.scale(), sign),
        c(leaf.field[2], leaves.scale(), sign) {}

  __attribute__((always_inline)) int32_t value(const FieldLeaves& leaves,
                                               FieldLeaf& leaf,
                                               uint32_t) const noexcept {
    const PixelPlace at = place();
    const int32_t shift = leaves.bend_shift();
    const auto number = [&leaf, &at ]() __attribute__((always_inline)) {
      leaf.place = at;
      return uint32_t{0};
    };
    return with_sign(leaves.least_of_three(leaf, a.value(at, shift, sign),
                                           b.value(at, shift, sign),
                                           c.value(at, shift, sign), number),
                     sign);
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
    const auto number = [&leaf, &at] {
      leaf.place = at;
      return uint32_t{0};
    };
    const int32_t least =
        count == 1 ? values[0]
                   : leaves.least_of_three(leaf, values[0], values[1],
                                           values[2], number);
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
// matter. [px]
constexpr uint32_t kMinWide = 6;

// Draws bands of points that are a brush's step apart.
class SlantedBand : public FieldBand {
 public:
  SlantedBand(const Slanted& slanted, const Stretching* stretching) noexcept
      : FieldBand(slanted.field,
                  scale_of(slanted.brush),
                  slanted.brush.filter(),
                  stretching == nullptr ? reach_of(slanted.brush.filter())
                                        : stretching->far_q22,
                  0),
        slanted_(slanted),
        stretching_(stretching) {
    if (stretching != nullptr) {
      set_far(-stretching->far_q22, stretching->far_q22);
    }
    const GlyphStep& right = slanted.brush.right();
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
  const GlyphStep& right = slanted_.brush.right();
  const GlyphStep& up = slanted_.brush.up();
  const auto right_x = static_cast<uint32_t>(right.x_q16);
  const auto right_y = static_cast<uint32_t>(right.y_q16);
  // The part of the square that may show: how wide it is, and where the point
  // lies in it, from its corner.
  const uint32_t mask = (1u << (leaf.size_log2 + 16)) - 1;
  const auto meet = [mask](uint32_t place, uint32_t low, uint32_t length,
                           uint32_t& at) noexcept {
    const uint32_t way = place - low;
    at = lesser(place & mask, way);
    return at + lesser(~place & mask, length - 1 - way) + 1;
  };
  const Window& limits = slanted_.limits;
  uint32_t x;
  uint32_t y;
  const uint32_t across = meet(x_q16, limits.left_q16, limits.width_q16, x);
  const uint32_t high = meet(y_q16, limits.low_q16, limits.height_q16, y);
  int32_t begin = leaf.spans[0].begin;
  int32_t end = begin + 1;
  if (size_q18(leaf) >= kMinWide << 18) {
    const uint32_t steps = slanted_.across.steps_within(
        x, across, static_cast<uint32_t>(width - end));
    end += static_cast<int32_t>(slanted_.up.steps_within(y, high, steps));
  } else {
    uint32_t end_x = x + right_x;
    uint32_t end_y = y + right_y;
    while (end != width && end_x < across && end_y < high) {
      ++end;
      end_x += right_x;
      end_y += right_y;
    }
  }
  int32_t row = 0;
  while (true) {
    leaf.spans[row] = {static_cast<uint8_t>(begin), static_cast<uint8_t>(end)};
    todo[row] &= ~bits_between(begin, end);
    if (++row == height) {
      break;
    }
    x -= static_cast<uint32_t>(up.x_q16);
    y -= static_cast<uint32_t>(up.y_q16);
    if (x < across && y < high) {
      while (begin != 0 && x - right_x < across && y - right_y < high) {
        x -= right_x;
        y -= right_y;
        --begin;
      }
    } else {
      do {
        x += right_x;
        y += right_y;
        ++begin;
      } while (begin != end && (x >= across || y >= high));
      if (begin == end) {
        break;
      }
    }
    const auto last = static_cast<uint32_t>(end - 1 - begin);
    uint32_t end_x = x + last * right_x;
    uint32_t end_y = y + last * right_y;
    if (end_x < across && end_y < high) {
      while (end != width) {
        end_x += right_x;
        end_y += right_y;
        if (end_x >= across || end_y >= high) {
          break;
        }
        ++end;
      }
    } else {
      do {
        end_x -= right_x;
        end_y -= right_y;
        --end;
      } while (end_x >= across || end_y >= high);
    }
  }
  leaf.height = static_cast<uint8_t>(row);
}

// What matters of a leaf in the box around its points, as far as that lies in
// its square.
__attribute__((noinline)) void SlantedBand::reduce_at(
    SlantedLeaf& leaf, const SlantedPoint& at) const noexcept {
  int32_t begin = kColumns;
  int32_t end = 0;
  for (int32_t row = 0; row < leaf.height; ++row) {
    begin = lesser(begin, leaf.spans[row].begin);
    end = greater(end, leaf.spans[row].end);
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
    const int32_t low_q12 = lesser(right_q12 * first, right_q12 * last) +
                            lesser(down_q12, int32_t{0});
    const int32_t high_q12 = greater(right_q12 * first, right_q12 * last) +
                             greater(down_q12, int32_t{0});
    const int32_t low =
        greater((low_q12 >> 4), -px_q8(place_q16 & mask)) - kMargin;
    const int32_t high =
        lesser((high_q12 >> 4), px_q8(~place_q16 & mask)) + kMargin;
    middle_q8 = q8_of(place_q20) + static_cast<uint32_t>((low + high) >> 1);
    half_q8 = static_cast<uint32_t>((high - low + 1) >> 1);
  };
  const GlyphStep& right = slanted_.brush.right();
  const GlyphStep& up = slanted_.brush.up();
  Extent all;
  meet(at.x_q16, at.x_q20, right.x_q20, up.x_q20, all.middle.x_q8,
       all.half_x_q8);
  meet(at.y_q16, at.y_q20, right.y_q20, up.y_q20, all.middle.y_q8,
       all.half_y_q8);
  all.sign = leaf.sign;
  all.right = &right;
  reduce(leaf, all);
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
    terms.go_down(slanted_.brush);
    line += kColumns + shift;
  }
}

// Not inline: the loops have the registers for themselves.
template <typename Terms>
__attribute__((noinline)) void SlantedBand::paint_as(
    SlantedLeaf& leaf, const SlantedPoint& at) const noexcept {
  Terms terms(Pen(slanted_.brush, at), *this, leaf);
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
    if (leaf.has_lines(1)) {
      paint_as<OneAt<LineAt>>(leaf, at);
    } else {
      paint_as<OneAt<ArcAt>>(leaf, at);
    }
  } else if (leaf.count == 2) {
    if (leaf.has_lines(2)) {
      paint_as<TwoAt<LineAt>>(leaf, at);
    } else {
      paint_as<TwoAt<ArcAt>>(leaf, at);
    }
  } else if (leaf.has_lines(3)) {
    paint_as<ThreeAt<LineAt>>(leaf, at);
  } else {
    paint_as<ThreeAt<ArcAt>>(leaf, at);
  }
}

__attribute__((noinline)) void SlantedBand::paint_stretched(
    SlantedLeaf& leaf, const SlantedPoint& at) const noexcept {
  StretchedAt stretched(Pen(slanted_.brush, at), *stretching_);
  paint(stretched, leaf);
}

// Not inline: its leaf is off the stack when rows are handed on.
__attribute__((noinline)) bool SlantedBand::cover(
    const SlantedPoint& first,
    int32_t width,
    int32_t height,
    Pixels& pixels) const noexcept {
  const Brush& brush = slanted_.brush;
  height = rows_of(height);
  pixels.clear(height);
  uint32_t todo[kRows];
  for (int32_t y = 0; y < height; ++y) {
    todo[y] = bits_between(0, width);
  }
  const GlyphStep& right = brush.right();
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
      leaf.skip_q15 = 0;
      if (kObjectOrder && may_reduce_ && leaf.count != 0 &&
          size_q18(leaf) >= kMinWide << 18) {
        reduce_at(leaf, at);
      }
      if (leaf.count != 0 || leaf.is_inside) {
        any = true;
        paint_leaf(leaf, at);
      }
    }
    row.go(brush.up(), UINT32_MAX);
  }
  return any;
}

}  // namespace

int32_t stretched_value(const Stretching& stretching,
                        const FieldLeaves& leaves,
                        const FieldLeaf& leaf,
                        const PixelPlace& at) {
  const int32_t bend_log2 = leaves.scale().bend_log2;
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
    const int32_t value_q22 = with_sign(term.value_q22(bend_log2), sign);
    if (value_q22 <= -far_q22 && (i == 0 || !leaf.is_nested)) {
      return with_sign(value_q22, sign);
    }
    least_q22 = lesser(least_q22, value_q22);
  }
  if (least_q22 >= far_q22) {
    return with_sign(least_q22, sign);
  }
  stretch_terms(stretching.brush, far_q22, terms);
  const int32_t value_q22 = combine_q22(terms, bend_log2, stretching.reach_q22);
  return lesser(greater(value_q22, -far_q22), far_q22);
}

void draw_slanted(const Slanted& slanted,
                  const Stretching* stretching,
                  SlantedPoint first,
                  const Rect& box,
                  const Sink& sink) noexcept {
  const SlantedBand band(slanted, stretching);
  const GlyphStep& right = slanted.brush.right();
  const GlyphStep& up = slanted.brush.up();
  int32_t rows;
  for (int32_t y = box.y0; y < box.y1; y += rows) {
    rows = FieldBand::rows_of(box.y1 - y);
    int32_t count;
    for (int32_t x = box.x0; x < box.x1; x += count) {
      FieldBand::Pixels lines;
      count = lesser(box.x1 - x, FieldBand::kColumns);
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
