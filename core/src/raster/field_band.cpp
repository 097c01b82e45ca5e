// Bands of cells of primitives. Their leaves are met from top to bottom; where
// each of them ends is kept in the column that it begins at:
//
//        a a b b b        row 0 finds a and b,
//        a a b b b        row 1 nothing new,
//        c d b b b        row 2 finds c and d.
//
// In a leaf its fields are set up once and followed by addition. A pixel that
// is saturated tells how many behind it are so, too: as many as the slopes of
// the fields, which are known for all but the smallest leaves, allow.
#include "raster/field_band.hpp"

#include "base/math.hpp"
#include "distance/field_terms.hpp"

namespace inkcell {
namespace detail {
namespace {

// From this width and height together on it pays to ask which fields matter.
// [px]
constexpr int32_t kMinReduced = 8;

// One field along a row.
template <typename Term>
struct OneTerm {
  Term a;

  __attribute__((always_inline))
  OneTerm(const FieldLeaves& leaves, const FieldLeaf& leaf) noexcept
      : a(leaf.field[0], leaf.place, leaves.scale(), 0) {}

  __attribute__((always_inline)) int32_t value(const FieldLeaves& leaves,
                                               const FieldLeaf&,
                                               uint32_t) const noexcept {
    return a.value(leaves.bend_shift(), 0);
  }
  __attribute__((always_inline)) void go_on(uint32_t count) noexcept {
    a.go_on(count);
  }
  __attribute__((always_inline)) void go_down(FieldLeaf&,
                                              uint32_t way_q8) noexcept {
    a.go_down(way_q8);
  }
  __attribute__((always_inline)) bool is_steady() const noexcept {
    return a.is_steady();
  }
};

// Two fields, or three.
template <typename Fields>
struct SomeTerms : Fields {
  __attribute__((always_inline))
  SomeTerms(const FieldLeaves& leaves, const FieldLeaf& leaf) noexcept
      : Fields(leaf, leaves.scale(), leaf.place) {}

  __attribute__((always_inline)) int32_t value(const FieldLeaves& leaves,
                                               const FieldLeaf& leaf,
                                               uint32_t number) const noexcept {
    return this->combined(leaves, leaf, RowNumber{number});
  }
  __attribute__((always_inline)) void go_on(uint32_t count) noexcept {
    this->each([count](auto& term)
                   __attribute__((always_inline)) { term.go_on(count); });
  }
  __attribute__((always_inline)) void go_down(FieldLeaf& leaf,
                                              uint32_t way_q8) noexcept {
    leaf.place.y_q8 -= way_q8;
    this->each([way_q8](auto& term)
                   __attribute__((always_inline)) { term.go_down(way_q8); });
  }
};

// Any number of fields: smaller than all of those above.
struct AllTerms {
  int32_t sign;
  uint32_t count;
  ArcTerm term[3];

  AllTerms(const FieldLeaves& leaves, const FieldLeaf& leaf) noexcept
      : sign(leaf.sign), count(leaf.count) {
    for (uint32_t i = 0; i < count; ++i) {
      term[i] = ArcTerm(leaf.field[i], leaf.place, leaves.scale(), sign);
    }
  }

  int32_t value(const FieldLeaves& leaves,
                const FieldLeaf& leaf,
                uint32_t number) const noexcept {
    // Two are three of which one is never the least.
    int32_t values[3] = {0, 0, INT32_MAX};
    for (uint32_t i = 0; i < count; ++i) {
      values[i] = term[i].value(leaves.bend_shift(), sign);
    }
    const int32_t least =
        count == 1 ? values[0]
                   : leaves.least_of_three(leaf, values[0], values[1],
                                           values[2], RowNumber{number});
    return with_sign(least, sign);
  }
  void go_on(uint32_t points) noexcept {
    for (uint32_t i = 0; i < count; ++i) {
      term[i].go_on(points);
    }
  }
  void go_down(FieldLeaf& leaf, uint32_t way_q8) noexcept {
    leaf.place.y_q8 -= way_q8;
    for (uint32_t i = 0; i < count; ++i) {
      term[i].go_down(way_q8);
    }
  }
  bool is_steady() const noexcept { return false; }
};

// Repeats a row in those below it.
inline void repeat(uint8_t* line, int32_t width, int32_t rows) noexcept {
  for (uint8_t* to = line; rows != 0; --rows) {
    to += FieldBand::kColumns;
    for (int32_t x = 0; x < width; ++x) {
      to[x] = line[x];
    }
  }
}

}  // namespace

inline int32_t FieldBand::points_upto(uint32_t way_q16,
                                      int32_t most) const noexcept {
#if defined(__ARM_ARCH_6M__)
  // No division there. A guess from a px being 65536 u / size: right, or up to
  // two too low.
  const uint32_t size_q6 = scale_.size_q8 >> 2;
  auto count = static_cast<int32_t>(((way_q16 >> 13) * size_q6) >> 19) + 1;
  uint32_t at_q16 = static_cast<uint32_t>(count) * step_q16_;
  for (; at_q16 <= way_q16; at_q16 += step_q16_) {
    ++count;
  }
#else
  const auto count = static_cast<int32_t>(way_q16 / step_q16_) + 1;
#endif
  return min(count, most);
}

// Not inline: the loops have the registers for themselves.
template <typename Terms>
__attribute__((noinline)) void FieldBand::paint(BoxLeaf& leaf) const noexcept {
  Terms terms(*this, leaf);
  uint8_t* line = leaf.line;
  uint8_t* end = line + leaf.width;
  int32_t rows = leaf.height;
  while (true) {
    const uint8_t* const out = paint_row(terms, leaf, line, end);
    if (--rows == 0) {
      return;
    }
    if (terms.is_steady()) {
      repeat(line, leaf.width, rows);
      return;
    }
    terms.go_on(static_cast<uint32_t>(line - out));
    terms.go_down(leaf, 1 << 8);
    line += kColumns;
    end += kColumns;
  }
}

// Half of the leaves of small text have one point. Without loops, and what
// leads to other points, one function serves all of them.
__attribute__((noinline)) uint8_t FieldBand::coverage_of_point(
    const FieldLeaf& leaf) const noexcept {
  const int32_t sign = leaf.sign;
  const auto value = [&](uint32_t i) __attribute__((always_inline)) {
    const ArcTerm term(leaf.field[i], leaf.place, scale_, 0);
    return term.value(bend_shift(), 0);
  };
  // A single one has no sign.
  int32_t distance = value(0);
  if (leaf.count != 1) {
    const int32_t first = with_sign(distance, sign);
    const int32_t second = with_sign(value(1), sign);
    distance =
        with_sign(leaf.count == 2
                      ? least_of_two(leaf, first, second, RowNumber{0})
                      : least_of_three(leaf, first, second,
                                       with_sign(value(2), sign), RowNumber{0}),
                  sign);
  }
  const uint32_t way = ramp_.way_q22(distance);
  if (way < ramp_.width_q22) {
    return ramp_.at(way);
  }
  return distance < ramp_.low_q22 ? 0 : 255;
}

inline void FieldBand::paint_leaf(BoxLeaf& leaf) const noexcept {
  if (leaf.count == 0) {
    uint8_t* line = leaf.line;
    for (int32_t rows = leaf.height; rows != 0; --rows, line += kColumns) {
      fill(line, leaf.width);
    }
    return;
  }
  if constexpr (!kFastRows) {
    paint<AllTerms>(leaf);
  } else if (leaf.count == 1) {
    if (leaf.has_lines(1)) {
      paint<OneTerm<LineTerm>>(leaf);
    } else {
      paint<OneTerm<ArcTerm>>(leaf);
    }
  } else if (leaf.count == 2) {
    if (leaf.has_lines(2)) {
      paint<SomeTerms<TwoFields<LineTerm>>>(leaf);
    } else {
      paint<SomeTerms<TwoFields<ArcTerm>>>(leaf);
    }
  } else if (leaf.has_lines(3)) {
    paint<SomeTerms<ThreeFields<LineTerm>>>(leaf);
  } else {
    paint<SomeTerms<ThreeFields<ArcTerm>>>(leaf);
  }
}

__attribute__((noinline)) void FieldBand::reduce_box(
    BoxLeaf& leaf) const noexcept {
  Extent all;
  const uint32_t depth_q8 =
      leaf.place.y_q8 - height_q8(leaf.row + leaf.height - 1);
  all.half_x_q8 = static_cast<uint32_t>(leaf.width - 1) << 7;
  all.half_y_q8 = (depth_q8 + 1) >> 1;
  all.middle = {leaf.place.x_q8 + all.half_x_q8,
                leaf.place.y_q8 - (depth_q8 >> 1)};
  all.sign = leaf.sign;
  all.right = nullptr;
  reduce(leaf, all);
}

bool FieldBand::cover(int32_t width,
                      int32_t height,
                      uint8_t* lines) const noexcept {
  height = rows_of(height);
  // Of each leaf the row behind its last one, less one, and its width less one;
  // 0 where none begins yet.
  uint32_t words[kColumns / 4];
  static_assert(kRows <= 8 && kColumns <= 32, "3 and 5 bits");
  auto* const drawn = reinterpret_cast<uint8_t*>(words);
  clear_row(words);
  const uint8_t* shown = nullptr;  // the last leaf
  int32_t y = 0;
  while (true) {
    const uint32_t row_q16 = height_q16(y);
    const uint32_t row_q8 = height_q8(y);
    int32_t next = height;
    int32_t x = 0;
    do {
      const uint32_t last = drawn[x];
      const auto last_y = static_cast<int32_t>(last >> 5);
      if (y != 0 && last_y >= y) {
        x += static_cast<int32_t>(last & 31) + 1;
        next = min(next, last_y + 1);
        continue;
      }
      BoxLeaf leaf;
      const uint32_t x_q16 = left_q16_ + static_cast<uint32_t>(x) * step_q16_;
      find_leaf(x_q16 >> 16, row_q16 >> 16, leaf);
      const uint32_t mask = (uint32_t{1 << 16} << leaf.size_log2) - 1;
      int32_t right = 1;
      int32_t down = 1;
      if (__builtin_expect(mask >= step_q16_, 1)) {
        right = points_upto(~x_q16 & mask, width - x);
        down = points_upto(row_q16 & mask, height - y);
        // Both less one.
        drawn[x] = static_cast<uint8_t>((y + down) * 32 + right - 33);
        next = min(next, y + down);
      } else {
        next = y + 1;
      }
      if (__builtin_expect(leaf.count != 0 || leaf.is_inside, 1)) {
        uint8_t* const line = lines + x;
        leaf.place = {left_q8_ + (static_cast<uint32_t>(x) << 8), row_q8};
        if (kFastRows && leaf.count != 0 && right + down == 2) {
          shown = line;
          *line = coverage_of_point(leaf);
        } else {
          leaf.line = line;
          leaf.width = static_cast<uint16_t>(right);
          leaf.height = static_cast<uint8_t>(down);
          leaf.row = static_cast<uint16_t>(y);
          if (leaf.count != 0 && right + down >= kMinReduced) {
            reduce_box(leaf);
          } else {
            leaf.know_nothing();
          }
          if (leaf.count != 0 || leaf.is_inside) {
            shown = line;
            paint_leaf(leaf);
          }
        }
      }
      x += right;
    } while (x < width);
    if (next == height) {
      return shown != nullptr;
    }
    lines += (next - y) * kColumns;
    y = next;
  }
}

}  // namespace detail
}  // namespace inkcell
