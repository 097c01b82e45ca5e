// What it takes to draw slanted rows of a glyph.
#pragma once

#include <stdint.h>

#include "field_cell.hpp"
#include "field_draw.hpp"
#include "position.hpp"
#include "span_writer.hpp"

namespace inkcell {
namespace detail {

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

inline uint32_t lesser(uint32_t a, uint32_t b) noexcept {
  return a < b ? a : b;
}

// A coordinate along a row, and when it leaves where it is, without a division.
// [u, Q16]
struct AxisStep {
  uint32_t size;
  uint32_t inverse_q27;  // cut to what products can bear: a guess
  bool falls;

  explicit AxisStep(int32_t step_q16) noexcept
      : size(static_cast<uint32_t>(step_q16 < 0 ? -step_q16 : step_q16)),
        inverse_q27(size < 1 << 12 ? 1u << 15 : (1u << 27) / size),
        falls(step_q16 < 0) {}

  // Whole steps that fit into a way below 2^31: `most`, up to 2^16, if more do.
  uint32_t steps_in(uint32_t way, uint32_t most) const noexcept {
    // Slow ones, which the inverse does not serve, rarely leave at all.
    if (size < 1 << 12 && size * most <= way) {
      return most;
    }
    const uint32_t near = lesser(way >> 11, uint32_t{1} << 16);
    uint32_t steps = (near * inverse_q27) >> 16;
    // Both factors are cut, so that the guess is not too high.
    for (uint32_t left = way - steps * size; left >= size && steps < most;
         left -= size) {
      ++steps;
    }
    return lesser(steps, most);
  }
  // The same before a coordinate leaves its square.
  uint32_t steps_in_square(uint32_t at,
                           uint32_t square_log2,
                           uint32_t most) const noexcept {
    const uint32_t low = at & ((1u << square_log2) - 1);
    return steps_in(falls ? low : (1u << square_log2) - 1 - low, most);
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

struct Slanted;

// The value of a leaf where edges are stretched differently, the plain way,
// negated if the leaf is.
int32_t stretched_value(const Slanted& slanted,
                        const SlantedLeaf& leaf,
                        const PointQ8& at);
using StretchedValue = decltype(stretched_value)*;

// What a glyph's pixels have in common.
struct Slanted {
  const GlyphField& field;
  const Brush& brush;
  StretchedValue stretch;  // null: edges are stretched alike
  int32_t reach_q22;
  int32_t far_q22;  // fields' values from here on decide
  FieldScale scale;
  // The limits of what may show, from the grid's corner.
  uint32_t left_q16;
  uint32_t low_q16;
  uint32_t width_q16;
  uint32_t height_q16;
  AxisStep across;
  AxisStep up;
  SpanWriter writer;

  Slanted(const GlyphField& glyph,
          const Brush& its_brush,
          StretchedValue its_stretch,
          const Sink& sink,
          int32_t y) noexcept
      : field(glyph),
        brush(its_brush),
        stretch(its_stretch),
        reach_q22(reach_of(its_brush.filter())),
        far_q22(reach_q22),
        scale(scale_of(its_brush)),
        across(its_brush.right().x_q16),
        up(its_brush.right().y_q16),
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

  // Less than 2 px along each axis of the glyph.
  bool has_short_steps() const noexcept {
    const GlyphStep& right = brush.right();
    constexpr int32_t kLimit = 1 << 21;
    return right.x_q20 < kLimit && right.x_q20 > -kLimit &&
           right.y_q20 < kLimit && right.y_q20 > -kLimit;
  }
  // How many pixels of a row from one that may show, `most` or fewer.
  int32_t count_shown(const RowPoint& at, int32_t most) const noexcept {
    const uint32_t x = at.x_q16 - left_q16;
    const uint32_t y = at.y_q16 - low_q16;
    const uint32_t more =
        lesser(static_cast<uint32_t>(most) - 1, uint32_t{1} << 16);
    const uint32_t across_steps =
        across.steps_in(across.falls ? x : width_q16 - 1 - x, more);
    return static_cast<int32_t>(
        up.steps_in(up.falls ? y : height_q16 - 1 - y, across_steps) + 1);
  }
  bool may_show(const RowPoint& at) const noexcept {
    return at.x_q16 - left_q16 < width_q16 && at.y_q16 - low_q16 < height_q16;
  }
};

// Draws `count` pixels of a row of cells of fields; all of them may show.
void draw_slanted_row(Slanted& slanted,
                      RowPoint at,
                      int32_t x,
                      int32_t count) noexcept;

}  // namespace detail
}  // namespace inkcell
