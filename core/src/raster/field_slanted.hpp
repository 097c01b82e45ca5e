// What it takes to draw glyphs that do not stand upright.
#pragma once

#include <stdint.h>

#include "cells/field_cell.hpp"
#include "distance/field_leaves.hpp"
#include "place/position.hpp"
#include "raster/field_draw.hpp"

namespace inkcell {
namespace detail {

// Where a pixel's centre lies, in u from the grid's corner and in px.
struct SlantedPoint {
  uint32_t x_q16;
  uint32_t y_q16;
  uint32_t x_q20;
  uint32_t y_q20;

  void go(const GlyphStep& step, uint32_t count = 1) noexcept {
    x_q16 += times(step.x_q16, count);
    y_q16 += times(step.y_q16, count);
    x_q20 += times(step.x_q20, count);
    y_q20 += times(step.y_q20, count);
  }
};

inline uint32_t min(uint32_t a, uint32_t b) noexcept {
  return a < b ? a : b;
}
inline uint32_t max(uint32_t a, uint32_t b) noexcept {
  return a > b ? a : b;
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
    const uint32_t near = min(way >> 11, uint32_t{1} << 16);
    uint32_t steps = (near * inverse_q27) >> 16;
    // Both factors are cut, so that the guess is not too high.
    for (uint32_t left = way - steps * size; left >= size && steps < most;
         left -= size) {
      ++steps;
    }
    return min(steps, most);
  }
  // Steps before a coordinate leaves a span that it lies in, from its start.
  uint32_t steps_within(uint32_t at,
                        uint32_t width,
                        uint32_t most) const noexcept {
    return steps_in(falls ? at : width - 1 - at, most);
  }
  // Steps until it lies in the span: `most` if these are too few.
  uint32_t steps_to(uint32_t at, uint32_t width, uint32_t most) const noexcept {
    if (at < width) {
      return 0;
    }
    const uint32_t way = falls ? at - width : ~at;  // less one
    // Behind it, or so far before it that this many, of 256 u at the most, do
    // not lead there.
    constexpr uint32_t kFew = 120;
    return min(way >> 31 != 0 ? kFew : steps_in(way, most) + 1, most);
  }
};

// A rectangle of the grid, from its corner. [u]
struct Window {
  uint32_t left_q16;
  uint32_t low_q16;
  uint32_t width_q16;
  uint32_t height_q16;

  bool holds(uint32_t x_q16, uint32_t y_q16) const noexcept {
    return x_q16 - left_q16 < width_q16 && y_q16 - low_q16 < height_q16;
  }
};

// A glyph, and how rows of pixels cross it.
struct Slanted {
  const GlyphField& field;
  const TextStyle& style;
  AxisStep across;
  AxisStep up;
  Window limits;  // of what may show

  Slanted(const GlyphField& glyph, const TextStyle& its_style) noexcept
      : field(glyph),
        style(its_style),
        across(its_style.right().x_q16),
        up(its_style.right().y_q16) {
    const Rect inner = limits_of(field, style);
    const auto side = [](int32_t low, int32_t high) noexcept {
      return low < high ? static_cast<uint32_t>(high - low) << 16 : 0;
    };
    limits = {side(field.x0_u, inner.x0), side(field.y0_u, inner.y0),
              side(inner.x0, inner.x1), side(inner.y0, inner.y1)};
  }

  bool may_show(const SlantedPoint& at) const noexcept {
    return limits.holds(at.x_q16, at.y_q16);
  }
  // How many points of a row from one that may show on may show, `most` or
  // fewer.
  int32_t count_shown(const SlantedPoint& at, int32_t most) const noexcept {
    const uint32_t steps =
        across.steps_within(at.x_q16 - limits.left_q16, limits.width_q16,
                            static_cast<uint32_t>(most) - 1);
    return 1 + static_cast<int32_t>(up.steps_within(at.y_q16 - limits.low_q16,
                                                    limits.height_q16, steps));
  }
  // How many points of a row from one that shows nothing on show nothing, for
  // sure; at least one, `most` or fewer.
  int32_t count_before(uint32_t x_q16,
                       uint32_t y_q16,
                       int32_t most) const noexcept {
    const auto limit = static_cast<uint32_t>(most);
    return static_cast<int32_t>(
        max(across.steps_to(x_q16 - limits.left_q16, limits.width_q16, limit),
            up.steps_to(y_q16 - limits.low_q16, limits.height_q16, limit)));
  }
};

struct Stretching;

// The value of a leaf at a point where edges are stretched differently, the
// plain way, negated if the leaf is.
int32_t stretched_value(const Stretching& stretching,
                        const FieldLeaves& leaves,
                        const FieldLeaf& leaf,
                        const PixelPlace& at);

// How edges are stretched. Only what stretches makes one, so that others do not
// link it.
struct Stretching {
  decltype(stretched_value)* value;
  const TextStyle& style;
  int32_t reach_q22;
  int32_t far_q22;  // fields' values from here on decide
};

// Draws the pixels of `box` of a glyph of fields, given where its first pixel
// lies. `stretching` is null if edges are stretched alike.
void draw_slanted(const Slanted& slanted,
                  const Stretching* stretching,
                  SlantedPoint first,
                  const Rect& box,
                  const Sink& sink) noexcept;

}  // namespace detail
}  // namespace inkcell
