// What bands of cells of primitives share, upright or not: a few rows of a
// strip at a time, in which each leaf is found and set up once.
#pragma once

#include <stdint.h>

#include "distance/field_leaves.hpp"
#include "inkcell/filter.hpp"
#include "inkcell/text_style.hpp"
#include "raster/coverage_ramp.hpp"

namespace inkcell {
namespace detail {

// Draws bands of points of leaves.
class LeafBand : public FieldLeaves {
 public:
  // The most rows and columns of a band: what the stack can bear.
  static constexpr int32_t kRows = 8;
  static constexpr int32_t kColumns = 24;

  // How many rows a band has where so many are left, one at the least.
  static int32_t rows_of(int32_t left) noexcept { return min(left, kRows); }

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

  LeafBand(const GlyphField& field,
           const FieldScale& scale,
           const Filter& filter,
           int32_t reach_q22) noexcept
      : FieldLeaves(field, scale, reach_q22), ramp_(filter) {
    const int32_t high_q22 =
        ramp_.low_q22 + static_cast<int32_t>(ramp_.width_q22);
    limit_rounded(ramp_.low_q22 - 1, high_q22);
    set_far(min(ramp_.low_q22, 0), max(high_q22, 0));
  }

 protected:
  // A leaf's points in a band.
  struct BandLeaf : FieldLeaf {
    uint8_t height;  // how many rows
    // After how many points a distance has gained 1/64 px, or fewer. [Q15]
    uint16_t skip_q15;
    // All bits, if what follows a point that is saturated on that side is so,
    // too.
    uint16_t all_outside;
    uint16_t all_inside;
    uint8_t* line;  // where the first point is drawn

    // Says that points tell nothing of others.
    void know_nothing() noexcept { skip_q15 = all_outside = all_inside = 0; }
  };

  // What a field shows of a leaf's points: nothing, all, or what distances say.
  enum class Side : uint8_t { outside, edge, inside };

  // How a field changes from point to point, with the leaf's sign. [Q14]
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
    // Leads to the next point, below 2 px along each axis; null: a px right.
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
    while (end - at >= 4) {
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

  CoverageRamp ramp_;

 private:
  enum class Form : uint8_t { line, arc, any };
  template <Form kForm>
  Side side_as(const uint8_t* field,
               const Extent& all,
               Slopes& slopes) const noexcept;
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

  // From there on distances tell of others. Nearer ones may be rounded, which
  // leads back to the ramp if it lies beside the edge. [px]
  int32_t far_outside_q22_ = 0;
  int32_t far_inside_q22_ = 0;
};

template <typename Terms>
__attribute__((always_inline)) inline const uint8_t* LeafBand::paint_row(
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
    if (beyond_q22 <= 0) {
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
