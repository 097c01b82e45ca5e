// The loops that evaluate a leaf's samples.
#pragma once

#include <stdint.h>

#include "cells/leaf_reader.hpp"
#include "distance/samples.hpp"
#include "raster/cell_band.hpp"

namespace inkcell {
namespace detail {

// kCount values, with the leaf's sign, to a distance. `place()` is the point.
template <uint32_t kCount, typename Value, typename Place>
__attribute__((always_inline)) inline int32_t combine(
    const Csg& csg,
    TileLeaf& leaf,
    int32_t sign,
    const Value& value,
    const Place& place) noexcept {
  if constexpr (kCount == 1) {
    return value(0);
  } else if constexpr (kCount == 2) {
    return with_sign(csg.min_of_two(leaf, value(0), value(1), place), sign);
  } else {
    return with_sign(
        csg.min_of_three(leaf, value(0), value(1), value(2), place), sign);
  }
}

// kCount primitives of a leaf.
template <typename Primitive, uint32_t kCount>
struct Primitives {
  int32_t sign;
  Primitive part[kCount];

  __attribute__((always_inline))
  Primitives(const Csg& csg, const TileLeaf& leaf) noexcept
      : sign(kCount == 1 ? 0 : leaf.sign) {
    part[0] = Primitive(leaf.parts[0], csg.scale(), sign);
    if constexpr (kCount > 1) {
      part[1] = Primitive(leaf.parts[1], csg.scale(), sign);
    }
    if constexpr (kCount > 2) {
      part[2] = Primitive(leaf.parts[2], csg.scale(), sign);
    }
  }
};

// Along rows of the glyph, a px from sample to sample.
template <typename Primitive, typename Row, uint32_t kCount>
struct RowValues : Primitives<Primitive, kCount> {
  static constexpr bool kHasSpans = false;
  using Primitives<Primitive, kCount>::part;
  Row row[kCount];
  PixelPlace place;  // of the row's first sample

  __attribute__((always_inline)) RowValues(const CellMap&,
                                           const Csg& csg,
                                           const TileLeaf& leaf,
                                           const GlyphPoint&) noexcept
      : Primitives<Primitive, kCount>(csg, leaf), place(leaf.place) {
    row[0].begin(part[0], place);
    if constexpr (kCount > 1) {
      row[1].begin(part[1], place);
    }
    if constexpr (kCount > 2) {
      row[2].begin(part[2], place);
    }
  }
  __attribute__((always_inline)) int32_t value(const Csg& csg,
                                               TileLeaf& leaf,
                                               uint32_t number) const noexcept {
    return combine<kCount>(
        csg, leaf, this->sign,
        [&](uint32_t i) __attribute__((always_inline)) {
          return row[i].value(part[i], csg.bend_shift(), this->sign);
        },
        [&]() __attribute__((always_inline)) {
          return PixelPlace{place.x_q8 + (number << 8), place.y_q8};
        });
  }
  __attribute__((always_inline)) void advance(uint32_t count) noexcept {
    row[0].advance(count);
    if constexpr (kCount > 1) {
      row[1].advance(count);
    }
    if constexpr (kCount > 2) {
      row[2].advance(count);
    }
  }
  __attribute__((always_inline)) void next_row(TileLeaf&,
                                               int32_t back) noexcept {
    place.y_q8 -= 1 << 8;
    advance(static_cast<uint32_t>(back));
    row[0].go_down(part[0]);
    if constexpr (kCount > 1) {
      row[1].go_down(part[1]);
    }
    if constexpr (kCount > 2) {
      row[2].go_down(part[2]);
    }
  }
  // Whether all rows are alike.
  __attribute__((always_inline)) bool is_steady() const noexcept {
    bool result = part[0].is_steady();
    if constexpr (kCount > 1) {
      result = result && part[1].is_steady();
    }
    if constexpr (kCount > 2) {
      result = result && part[2].is_steady();
    }
    return result;
  }
};

// A point that goes along samples, by any step.
struct Cursor {
  static constexpr bool kHasSpans = true;
  const CellMap& map;
  uint32_t x_q20;
  uint32_t y_q20;
  uint32_t right_x_q20;
  uint32_t right_y_q20;

  Cursor(const CellMap& its_map, const GlyphPoint& at) noexcept
      : map(its_map),
        x_q20(at.x_q20),
        y_q20(at.y_q20),
        right_x_q20(static_cast<uint32_t>(map.right.x_q20)),
        right_y_q20(static_cast<uint32_t>(map.right.y_q20)) {}

  __attribute__((always_inline)) PixelPlace place() const noexcept {
    return {q8_of(x_q20), q8_of(y_q20)};
  }
  __attribute__((always_inline)) void advance(uint32_t count) noexcept {
    x_q20 += count * right_x_q20;
    y_q20 += count * right_y_q20;
  }
  // To the first sample of the row below, from the last row's.
  __attribute__((always_inline)) void next_row(TileLeaf&,
                                               int32_t back) noexcept {
    advance(static_cast<uint32_t>(back));
    x_q20 -= static_cast<uint32_t>(map.up.x_q20);
    y_q20 -= static_cast<uint32_t>(map.up.y_q20);
  }
};

// Each sample for itself.
template <typename Primitive, uint32_t kCount>
struct PointValues : Cursor, Primitives<Primitive, kCount> {
  using Primitives<Primitive, kCount>::part;

  __attribute__((always_inline)) PointValues(const CellMap& its_map,
                                             const Csg& csg,
                                             const TileLeaf& leaf,
                                             const GlyphPoint& first) noexcept
      : Cursor(its_map, first), Primitives<Primitive, kCount>(csg, leaf) {}

  __attribute__((always_inline)) int32_t value(const Csg& csg,
                                               TileLeaf& leaf,
                                               uint32_t) const noexcept {
    const PixelPlace at = place();
    return combine<kCount>(
        csg, leaf, this->sign,
        [&](uint32_t i) __attribute__((always_inline)) {
          return part[i].at(at, csg.bend_shift(), this->sign);
        },
        [&]() __attribute__((always_inline)) { return at; });
  }
};

// A leaf's samples as whole points.
struct PointCursor {
  const CellMap& map;
  GlyphPoint at;
  uint32_t mask;  // of places in the cell

  PointCursor(const CellMap& its_map,
              const TileLeaf& leaf,
              const GlyphPoint& first) noexcept
      : map(its_map), at(first), mask((1u << (leaf.size_log2 + 16)) - 1) {}

  void advance(uint32_t count) noexcept { at.advance(map.right, count); }
  void next_row(TileLeaf&, int32_t back) noexcept {
    advance(static_cast<uint32_t>(back));
    at.advance(map.up, UINT32_MAX);
  }
};

// Any leaf where edges are stretched differently.
struct StretchedValues : PointCursor {
  static constexpr bool kHasSpans = true;

  StretchedValues(const CellMap& its_map,
                  const Csg&,
                  const TileLeaf& leaf,
                  const GlyphPoint& first) noexcept
      : PointCursor(its_map, leaf, first) {}

  int32_t value(const Csg& csg, TileLeaf& leaf, uint32_t) const noexcept {
    const Stretching& stretching = *csg.stretching();
    return leaf.has_samples() ? stretching.samples_value(
                                    csg, leaf, at.x_q16 & mask, at.y_q16 & mask)
                              : stretching.value(csg, leaf, at.place());
  }
};

// The distance of a leaf of samples at a place in the cell. [px]
inline int32_t samples_px_q22(const TextStyle& style,
                              const Leaf& leaf,
                              uint32_t x_q16,
                              uint32_t y_q16) noexcept {
  return style.to_px_q10(samples_distance_q10(leaf.parts[0], leaf.size_log2,
                                              x_q16, y_q16)) *
         (1 << 12);
}

// Nine samples, each point for itself.
struct SamplePoints : PointCursor {
  static constexpr bool kHasSpans = true;

  SamplePoints(const CellMap& its_map,
               const Csg&,
               const TileLeaf& leaf,
               const GlyphPoint& first) noexcept
      : PointCursor(its_map, leaf, first) {}

  int32_t value(const Csg&, const TileLeaf& leaf, uint32_t) const noexcept {
    return samples_px_q22(map.style, leaf, at.x_q16 & mask, at.y_q16 & mask);
  }
};

// Nine samples along rows of the glyph: parabolas. leaf.place is the first
// sample's in the cell. [u, Q16]
struct SampleRows {
  static constexpr bool kHasSpans = false;

  SampleRows(const CellMap& map,
             const Csg& csg,
             TileLeaf& leaf,
             const GlyphPoint&) noexcept
      : style_(map.style),
        x_q16_(leaf.place.x_q8),
        y_q16_(leaf.place.y_q8),
        step_q16_(static_cast<uint32_t>(map.right.x_q16)),
        // Roundings, a 4096th of the cell, must stay below the margin of what
        // tells of others.
        may_skip_(csg.scale().size_q8 << leaf.size_log2 < 256u << 18) {
    begin_row(leaf);
  }

  int32_t value(const Csg&, const TileLeaf&, uint32_t) const noexcept {
    return style_.to_px_q10(row_.distance_q10(static_cast<int32_t>(x_q16_))) *
           (1 << 12);
  }
  void advance(uint32_t count) noexcept { x_q16_ += count * step_q16_; }
  void next_row(TileLeaf& leaf, int32_t back) noexcept {
    advance(static_cast<uint32_t>(back));
    y_q16_ -= step_q16_;
    begin_row(leaf);
  }
  bool is_steady() const noexcept { return false; }

 private:
  // Up to this slope samples are skipped: distances have 1, and what nine
  // numbers make of them is a little steeper at corners. [1/64 quantum a cell]
  static constexpr int32_t kMostSlopeQ6 = (128 * 64 * 5) / 4;

  void begin_row(TileLeaf& leaf) noexcept {
    set_up_row(row_, leaf.parts[0], leaf.size_log2,
               static_cast<int32_t>(y_q16_));
    const int32_t end_slope = row_.b_q6 + 2 * row_.c_q6;
    const int32_t least = min(row_.b_q6, end_slope);
    const int32_t most = max(row_.b_q6, end_slope);
    leaf.disable_skip();
    if (may_skip_ && most <= kMostSlopeQ6 && least >= -kMostSlopeQ6) {
      leaf.skip_q15 = (1 << 23) / ((1 << 14) * 5 / 4);
      leaf.all_outside = most <= 0 ? UINT16_MAX : 0;
      leaf.all_inside = least >= 0 ? UINT16_MAX : 0;
    }
  }

  const TextStyle& style_;
  uint32_t x_q16_;
  uint32_t y_q16_;
  uint32_t step_q16_;
  bool may_skip_;
  SamplesRow row_;
};

template <typename Values>
__attribute__((always_inline)) inline const uint8_t* CellBand::paint_row(
    Values& values,
    TileLeaf& leaf,
    uint8_t* line,
    const uint8_t* end) const noexcept {
  const CoverageRamp& ramp = ramp_;
  // How many samples behind a saturated one are so, too, given how far beyond
  // it is. One that a rounded vertex saturates is next to the ramp.
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
        values.value(*this, leaf, static_cast<uint32_t>(out - line));
    const uint32_t way = ramp.above_q22(value);
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
    values.advance(count);
    out += count;
  }
}

// Copies a row to those below it.
inline void repeat(uint8_t* line, int32_t width, int32_t rows) noexcept {
  for (uint8_t* to = line; rows != 0; --rows) {
    to += kTileColumns;
    for (int32_t x = 0; x < width; ++x) {
      to[x] = line[x];
    }
  }
}

// Not inline: the loops have the registers for themselves.
template <typename Values>
__attribute__((noinline)) void CellBand::paint(
    TileLeaf& leaf, const GlyphPoint& at) const noexcept {
  Values values(map_, *this, leaf, at);
  uint8_t* line = leaf.line;
  int32_t rows = leaf.height;
  if constexpr (!Values::kHasSpans) {
    uint8_t* end = line + leaf.width;
    while (true) {
      const uint8_t* const out = paint_row(values, leaf, line, end);
      if (--rows == 0) {
        return;
      }
      if (values.is_steady()) {
        repeat(line, leaf.width, rows);
        return;
      }
      values.next_row(leaf, static_cast<int32_t>(line - out));
      line += kTileColumns;
      end += kTileColumns;
    }
  } else {
    for (const TileSpan* span = leaf.spans;; ++span) {
      const uint8_t* const out =
          paint_row(values, leaf, line, line + (span->end - span->begin));
      if (--rows == 0) {
        return;
      }
      const int32_t shift = span[1].begin - span->begin;
      values.next_row(leaf, static_cast<int32_t>(line - out) + shift);
      line += kTileColumns + shift;
    }
  }
}

}  // namespace detail
}  // namespace inkcell
