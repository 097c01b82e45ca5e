// Coverage of bands of cells of fields: a few rows of a strip at a time, in
// which each leaf is found and set up once.
#pragma once

#include <stdint.h>

#include "field_leaves.hpp"
#include "inkcell/brush.hpp"
#include "inkcell/filter.hpp"

namespace inkcell {
namespace detail {

// What turns distances into coverage: Filter, as inner loops read it.
struct CoverageRamp {
  int32_t low_q22;     // the least distance that is not transparent [px]
  uint32_t width_q22;  // from there to the least that is opaque
  uint32_t scale;      // entries per 1/1024 px, as in Filter
  const uint8_t* table;

  explicit CoverageRamp(const Filter& filter) noexcept
      : low_q22((filter.outside_q10 + 1) * (1 << 12)),
        width_q22(
            static_cast<uint32_t>(filter.inside_q10 - filter.outside_q10 - 1)
            << 12),
        scale(filter.scale),
        table(filter.table) {}

  // How far a distance lies above the lower end; on the ramp if below
  // width_q22.
  __attribute__((always_inline)) uint32_t way_q22(
      int32_t distance_q22) const noexcept {
    return static_cast<uint32_t>(distance_q22) - static_cast<uint32_t>(low_q22);
  }
  // Filter::coverage on the ramp.
  __attribute__((always_inline)) uint8_t at(uint32_t way_q22) const noexcept {
    return table[static_cast<uint8_t>(((way_q22 >> 12) + 1) * scale >> 14)];
  }
};

// Draws bands of points: here a px apart.
class FieldBand : public FieldLeaves {
 public:
  // The most rows and columns of a band: what the stack can bear.
  static constexpr int32_t kRows = FittedRows::kMost;
  static constexpr int32_t kColumns = 24;

  // How many rows a band has where so many are left, one at the least.
  static int32_t rows_of(int32_t left) noexcept {
    return kRows == 1 ? 1 : lesser(left, kRows);
  }

  // Coverage, row by row.
  struct Pixels {
    uint32_t words[kRows * kColumns / 4];

    uint8_t* row(int32_t y) noexcept {
      return reinterpret_cast<uint8_t*>(words) + y * kColumns;
    }
    void clear(int32_t rows) noexcept {
      for (int32_t y = 0; y < rows; ++y) {
        clear_row(words + y * (kColumns / 4));
      }
    }
  };

  FieldBand(const GlyphField& field,
            const FieldScale& scale,
            const Filter& filter,
            int32_t reach_q22,
            int32_t step_q16) noexcept
      : FieldLeaves(field, scale, reach_q22, step_q16), ramp_(filter) {
    if (kObjectOrder) {
      const int32_t high_q22 =
          ramp_.low_q22 + static_cast<int32_t>(ramp_.width_q22);
      limit_rounded(ramp_.low_q22 - 1, high_q22);
      set_far(lesser(ramp_.low_q22, 0), greater(high_q22, 0));
    }
  }

  // To a band by its first point, from the origin. Its rows lie a px apart, or
  // at `heights`, which must stay there.
  void go_to(const FieldPosition& at, const RowHeight* heights) noexcept {
    const RowHeight first =
        heights == nullptr ? RowHeight{at.y_q16, at.y_q20} : heights[0];
    left_q16_ = static_cast<uint32_t>(at.x_q16 - field_.x0_u * (1 << 16));
    top_q16_ = static_cast<uint32_t>(first.y_q16 - field_.y0_u * (1 << 16));
    left_q8_ = q8_of(at.x_q20);
    top_q8_ = q8_of(first.y_q20);
    heights_ = heights;
  }
  // As many points to the right.
  void go_right(int32_t count) noexcept {
    left_q16_ += static_cast<uint32_t>(count) * step_q16_;
    left_q8_ += static_cast<uint32_t>(count) << 8;
  }

  // The coverage of its points, all in the grid. False: it is 0 everywhere.
  bool cover(int32_t width, int32_t height, Pixels& pixels) const noexcept;

 protected:
  // A leaf's points in a band.
  struct BandLeaf : FieldLeaf {
    uint8_t width;
    uint8_t height;
    uint8_t row;  // the first one
    // How many points on a distance gains no more than 1/64 px. [Q15]
    uint16_t skip_q15;
    // All bits, if what follows a point that is saturated on that side is so,
    // too.
    uint16_t all_outside;
    uint16_t all_inside;
    uint8_t* line;  // where the first point is drawn
  };

  // What a field shows of a leaf's points: nothing, all, or what distances say.
  enum class Side : uint8_t { outside, edge, inside };

  // How a field changes from a point to the next one, with the leaf's sign.
  // [px per px, Q14]
  struct Slopes {
    int32_t least;
    int32_t greatest;
  };

  // Where a leaf's points lie, and its sign.
  struct Extent {
    PixelPlace middle;
    uint32_t half_x_q8;  // from there to the outer ones
    uint32_t half_y_q8;
    int32_t sign;
    // From a point to the next one, less than 2 px along each axis; null: a px
    // to the right.
    const GlyphStep* right;
  };

  // Distances that are farther than these tell of others.
  void set_far(int32_t outside_q22, int32_t inside_q22) noexcept {
    far_outside_q22_ = outside_q22 - kMarginQ22;
    far_inside_q22_ = inside_q22 + kMarginQ22;
  }
  // As many bytes as a row has.
  static void clear_row(uint32_t* word) noexcept {
    static_assert(kColumns == 4 * 6, "words");
    word[0] = word[1] = word[2] = word[3] = word[4] = word[5] = 0;
  }
  // Makes points opaque.
  static void fill(uint8_t* at, int32_t count) noexcept {
    uint8_t* const end = at + count;
    while (kObjectOrder && end - at >= 4) {
      if ((reinterpret_cast<uintptr_t>(at) & 3) == 0) {
        *reinterpret_cast<uint32_t*>(at) = UINT32_MAX;
        at += 4;
      } else {
        *at++ = 255;
      }
    }
    while (at != end) {
      *at++ = 255;
    }
  }

  // Draws a row of a leaf's points. Where the point lies that `terms` stopped
  // at.
  template <typename Terms>
  const uint8_t* paint_row(Terms& terms,
                           BandLeaf& leaf,
                           uint8_t* line,
                           const uint8_t* end) const noexcept;

  // Leaves out the fields that are saturated in all of a leaf's points, and
  // says how those that are left change.
  void reduce(BandLeaf& leaf, const Extent& all) const noexcept;

 private:
  // How many points lie before a place that is `way_q16` further on, the first
  // of them at 0; `most` at the most. [u]
  int32_t points_before(uint32_t way_q16, int32_t most) const noexcept;
  // Where a row lies. [u]
  uint32_t height_q16(int32_t row) const noexcept {
    return kRows == 1 || heights_ == nullptr
               ? top_q16_ - static_cast<uint32_t>(row) * step_q16_
               : static_cast<uint32_t>(heights_[row].y_q16 -
                                       field_.y0_u * (1 << 16));
  }
  // The same in px, modulo 2^24.
  uint32_t height_q8(int32_t row) const noexcept {
    return kRows == 1 || heights_ == nullptr
               ? top_q8_ - (static_cast<uint32_t>(row) << 8)
               : q8_of(heights_[row].y_q20);
  }
  // How many rows from one on, which lies at `first_q16`, lie in its square of
  // this size, before `end`.
  int32_t rows_in(uint32_t mask_q16,
                  uint32_t first_q16,
                  int32_t row,
                  int32_t end) const noexcept;
  uint8_t coverage_of_point(const FieldLeaf& leaf) const noexcept;
  void paint_leaf(BandLeaf& leaf) const noexcept;
  template <typename Terms>
  void paint(BandLeaf& leaf) const noexcept;

  void reduce(BandLeaf& leaf) const noexcept;
  Side side_of(const uint8_t* field,
               const Extent& all,
               Slopes& slopes) const noexcept;
  Side keep_edges(BandLeaf& leaf,
                  const Extent& all,
                  Slopes& slopes) const noexcept;
  Side keep_nested(BandLeaf& leaf,
                   const Extent& all,
                   Slopes& slopes) const noexcept;

  // More than what the roundings of two values of an arc make. [px]
  static constexpr int32_t kMarginQ22 = 1 << 18;

  CoverageRamp ramp_;
  // From there on distances tell of others. Between them and the ramp they may
  // be rounded, which leads back to it if it lies beside the edge. [px]
  int32_t far_outside_q22_ = 0;
  int32_t far_inside_q22_ = 0;
  const RowHeight* heights_ = nullptr;
  // Where the first point lies, from the grid's corner [u] and the origin [px].
  uint32_t left_q16_ = 0;
  uint32_t top_q16_ = 0;
  uint32_t left_q8_ = 0;
  uint32_t top_q8_ = 0;
};

template <typename Terms>
__attribute__((always_inline)) inline const uint8_t* FieldBand::paint_row(
    Terms& terms,
    BandLeaf& leaf,
    uint8_t* line,
    const uint8_t* end) const noexcept {
  const CoverageRamp& ramp = ramp_;
  // How many points behind a saturated one are so, too, given how far beyond it
  // is. One that a rounded vertex saturates is next to the ramp.
  const auto behind = [&leaf](int32_t beyond_q22, uint32_t all)
                          __attribute__((always_inline))
                              ->uint32_t {
    if (!kObjectOrder || beyond_q22 <= 0) {
      return 0;
    }
    const uint32_t beyond_q6 = static_cast<uint32_t>(beyond_q22) >> 16;
    return ((beyond_q6 | all) * leaf.skip_q15) >> 15;
  };
  // a - b; where a cell is beyond the format's limits it may wrap.
  const auto less = [](int32_t a, int32_t b) noexcept {
    return wrapped(static_cast<uint32_t>(a) - static_cast<uint32_t>(b));
  };
  uint8_t* out = line;
  while (true) {
    const int32_t value =
        terms.value(*this, leaf, static_cast<uint32_t>(out - line));
    const uint32_t way = ramp.way_q22(value);
    uint32_t count = 1;
    if (way < ramp.width_q22) {
      *out = ramp.at(way);
    } else if (value < ramp.low_q22) {
      count += behind(less(far_outside_q22_, value), leaf.all_outside);
    } else {
      count += behind(less(value, far_inside_q22_), leaf.all_inside);
      uint8_t* at = out;
      uint32_t left = count;
      do {
        *at++ = 255;
      } while (--left != 0 && at != end);
    }
    if (count >= static_cast<uint32_t>(end - out)) {
      return out;
    }
    terms.go_on(count);
    out += count;
  }
}

}  // namespace detail
}  // namespace inkcell
