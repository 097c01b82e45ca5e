// What paints one row of a field into a band.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "cell_values.hpp"
#include "field_rows.hpp"
#include "place/style_parts.hpp"
#include "tree.hpp"

namespace inkcell::detail {

// A full pixel of a band of areas.
inline constexpr int32_t kFullArea = 240;
inline constexpr int32_t kBandFraction = 10;  // of a band's units
inline constexpr int32_t kNearest = 127;      // steps of nearness

// By how much steeper than that of a square the ramp of a sample is that is 1
// px high and 1/3 px wide, by 1/32 of the gradient's component across: an edge
// of normal (n, m) covers it over a distance of n / 3 + m. [Q8]
inline constexpr uint16_t kSteepness[33] = {
    256, 253, 251, 249, 248, 246, 245, 244, 243, 243, 243,
    243, 243, 244, 245, 246, 248, 250, 252, 255, 259, 263,
    268, 274, 281, 289, 300, 313, 330, 353, 388, 448, 768};

// floor(value factor / 2^16), modulo 2^32.
inline int32_t scaled(int32_t value, int32_t factor_q16) noexcept {
#if defined(__ARM_ARCH_6M__)
  // No long products there.
  const auto high = static_cast<uint32_t>(factor_q16 >> 16);
  const auto low = static_cast<uint32_t>(factor_q16 & 0xffff);
  const auto rest = static_cast<uint32_t>(value & 1023);
  const uint32_t part = times(value >> 10, low) + (rest * low >> 10);
  return wrapped(times(value, high) +
                 static_cast<uint32_t>(wrapped(part) >> 6));
#else
  return static_cast<int32_t>((int64_t{value} * factor_q16) >> 16);
#endif
}

// From a glyph to units of a band with kBandFraction bits. [Q16]
struct BandScale {
  int32_t of_distance;  // of distances in u, Q10
  int32_t of_slope;     // from a slope, Q13, to what a sample changes by
  // Samples are 1/3 px across: to the right, or upwards.
  bool is_thin_right;
  bool is_thin_up;
};

// Writes nearness and toggles from left to right.
class DistanceBytes {
 public:
  static constexpr bool kHasSteepness = false;
  explicit DistanceBytes(const BandScale&) noexcept {}

  __attribute__((always_inline)) void put(uint8_t* at,
                                          int32_t value,
                                          int32_t) noexcept {
    const int32_t sign = value >> 31;
    const uint32_t steps = static_cast<uint32_t>(value ^ sign) >> kBandFraction;
    uint32_t byte = static_cast<uint32_t>(sign ^ before_) & 1;
    if (steps < kNearest) {
      byte |= 2 * (kNearest - steps);
    }
    *at = static_cast<uint8_t>(byte);
    before_ = sign;
  }
  // Samples from here on are far from the edge.
  __attribute__((always_inline)) void saturate(uint8_t* at,
                                               bool is_inside) noexcept {
    const int32_t sign = is_inside ? 0 : -1;
    if (sign != before_) {
      *at = 1;
      before_ = sign;
    }
  }

 private:
  int32_t before_ = -1;  // the sign of the sample to the left
};

// Writes differences of areas from left to right.
class AreaBytes {
 public:
  static constexpr bool kHasSteepness = true;
  explicit AreaBytes(const BandScale& scale) noexcept
      : is_thin_(scale.is_thin_right || scale.is_thin_up),
        is_thin_up_(scale.is_thin_up) {}

  // `change`: from this sample to the next one.
  void put(uint8_t* at, int32_t value, int32_t change) noexcept {
    constexpr int32_t kMost = kFullArea << kBandFraction;
    value = max(-kMost, min(value, kMost));
    if (is_thin_) {
      value = (value * steepness_q8(change)) >> 8;
    }
    const int32_t area =
        max(0, min((value >> kBandFraction) + kFullArea / 2, kFullArea));
    *at = static_cast<uint8_t>(area - before_);
    before_ = area;
  }
  void saturate(uint8_t* at, bool is_inside) noexcept {
    const int32_t area = is_inside ? kFullArea : 0;
    if (area != before_) {
      *at = static_cast<uint8_t>(area - before_);
      before_ = area;
    }
  }
  bool is_thin() const noexcept { return is_thin_; }

 private:
  int32_t steepness_q8(int32_t change) const noexcept {
    // 32nds of a full area: a third of a pixel, or a pixel, to the right.
    const int32_t full = (is_thin_up_ ? kFullArea : kFullArea / 3)
                         << kBandFraction;
    const auto size = static_cast<uint32_t>(min(abs(change >> 1), full / 2));
    const uint32_t right = size * 64 / static_cast<uint32_t>(full);
    return kSteepness[is_thin_up_ ? root_of(1024 - right * right) : right];
  }

  bool is_thin_;
  bool is_thin_up_;
  int32_t before_ = 0;  // the area of the sample to the left
};

// How many samples lie no farther on than `left_q16`, the first of them at 0;
// `most` at the most. [u]
inline int32_t samples_within(uint32_t left_q16,
                              uint32_t step_q16,
                              int32_t most) noexcept {
#if defined(__ARM_ARCH_6M__)
  // No division there.
  int32_t count = 1;
  while (count != most && left_q16 >= step_q16) {
    left_q16 -= step_q16;
    ++count;
  }
  return count;
#else
  return min(static_cast<int32_t>(left_q16 / step_q16) + 1, most);
#endif
}

// A row of a glyph's samples, all of which lie in the grid.
struct FieldRow {
  FieldTree tree;
  const FieldRows& rows;
  const BandScale& scale;
  uint32_t x_q16;  // of the next sample, from the grid's corner [u]
  uint32_t y_q16;

  template <typename Bytes>
  void paint(Bytes& bytes, uint8_t* at, uint8_t* end) noexcept {
    const auto step = static_cast<uint32_t>(rows.right().x_q16);
    do {
      const FieldLeaf leaf = tree.find(x_q16 >> 16, y_q16 >> 16);
      const uint32_t mask = (1u << (leaf.size_log2 + 16)) - 1;
      const int32_t count =
          samples_within(~x_q16 & mask, step, static_cast<int32_t>(end - at));
      if (leaf.samples == nullptr) {
        bytes.saturate(at, leaf.is_inside);
      } else {
        paint_leaf(bytes, leaf, x_q16 & mask, count, at);
      }
      x_q16 += static_cast<uint32_t>(count) * step;
      at += count;
    } while (at != end);
    bytes.saturate(at, false);
  }

  template <typename Bytes>
  __attribute__((noinline)) void paint_leaning(Bytes& bytes,
                                               uint8_t* at,
                                               uint8_t* end) noexcept {
    const GlyphStep& right = rows.right();
    const bool is_stretched = rows.style().is_stretched();
    const int32_t least_gain = StyleParts::least_gain_q15(rows.style());
    constexpr int32_t kFar = kFullArea << kBandFraction;
    FieldLeaf leaf = {nullptr, 0, false};
    uint32_t leaf_x = ~x_q16;  // no place of the leaf yet
    uint32_t leaf_y = y_q16;
    do {
      if (((x_q16 ^ leaf_x) | (y_q16 ^ leaf_y)) >> 16 >> leaf.size_log2 != 0) {
        leaf = tree.find(x_q16 >> 16, y_q16 >> 16);
        leaf_x = x_q16;
        leaf_y = y_q16;
      }
      if (leaf.samples == nullptr) {
        bytes.saturate(at, leaf.is_inside);
      } else {
        const uint32_t mask = (1u << (leaf.size_log2 + 16)) - 1;
        const uint32_t x = x_q16 & mask;
        const uint32_t y = y_q16 & mask;
        const SamplesRow row = cell_row(leaf.samples, leaf.size_log2, y);
        int32_t value = scaled(row.distance_q10(static_cast<int32_t>(x)),
                               scale.of_distance);
        int32_t change = 0;
        // Farther than this the least gain changes nothing.
        const bool is_far = scaled(value, 2 * least_gain) > kFar ||
                            scaled(value, 2 * least_gain) < -kFar;
        if (!is_far && (is_stretched || Bytes::kHasSteepness)) {
          const Gradient gradient =
              cell_point(leaf.samples, leaf.size_log2, x, y).gradient;
          const GlyphStep& px = rows.style().right();
          const auto slope_q14 =
              static_cast<int32_t>((int64_t{gradient.x.raw} * px.x_q20 +
                                    int64_t{gradient.y.raw} * px.y_q20) >>
                                   20);
          change = scaled(slope_q14 >> 1, scale.of_slope);
          if (is_stretched) {
            const int32_t gain_q16 = 2 * gain_q15(rows.style(), gradient);
            value = scaled(value, gain_q16);
            change = scaled(change, gain_q16);
          }
        }
        bytes.put(at, value, change);
      }
      x_q16 += static_cast<uint32_t>(right.x_q16);
      y_q16 += static_cast<uint32_t>(right.y_q16);
    } while (++at != end);
    bytes.saturate(at, false);
  }

 private:
  // Samples of a row that a leaf holds.
  static constexpr int32_t kChunk = 16;

  template <typename Bytes>
  __attribute__((always_inline)) void paint_leaf(Bytes& bytes,
                                                 const FieldLeaf& leaf,
                                                 uint32_t x_in_leaf,
                                                 int32_t count,
                                                 uint8_t* at) const noexcept {
    const uint32_t log2 = leaf.size_log2;
    const auto step = static_cast<uint32_t>(rows.right().x_q16);
    const SamplesRow row =
        cell_row(leaf.samples, log2, y_q16 & ((1u << (log2 + 16)) - 1));
    if (!Bytes::kHasSteepness && count == 1 && x_in_leaf < step) {
      bytes.put(at,
                scaled(row.distance_q10(static_cast<int32_t>(x_in_leaf)),
                       scale.of_distance),
                0);
      return;
    }
    // A step, in widths of the leaf.
    const auto step_q14 = static_cast<int32_t>(
        min(static_cast<int32_t>(step >> (log2 + 2)), 1 << 14));
    // With six bits more, which 16 steps need.
    const auto bend_q19 =
        static_cast<int32_t>((int64_t{row.c_q6} * step) >> (log2 + 9));
    const auto bend =
        static_cast<uint32_t>(scaled(bend_q19, scale.of_slope) >> 6);
    uint32_t skipped = 0;
    if (x_in_leaf >= step) {
      skipped = static_cast<uint32_t>(
                    samples_within(x_in_leaf, step, INT32_MAX) - 1) &
                (kChunk - 1);
    }
    do {
      const auto start = static_cast<int32_t>(x_in_leaf - skipped * step);
      const int32_t middle_q14 = (start >> (log2 + 2)) + (step_q14 >> 1);
      const int32_t slope_q13 = row.b_q6 + ((row.c_q6 * middle_q14) >> 13);
      auto value = static_cast<uint32_t>(
          scaled(row.distance_q10(start), scale.of_distance));
      auto change = static_cast<uint32_t>(scaled(slope_q13, scale.of_slope));
      if (skipped != 0) {
        value += skipped * change + (skipped * (skipped - 1) >> 1) * bend;
        change += skipped * bend;
      }
      const int32_t number = min(count, kChunk - static_cast<int32_t>(skipped));
      x_in_leaf += static_cast<uint32_t>(number) * step;
      count -= number;
      skipped = 0;
      for (uint8_t* const end = at + number; at != end; ++at) {
        bytes.put(at, wrapped(value), wrapped(change));
        value += change;
        change += bend;
      }
    } while (count != 0);
  }
};

}  // namespace inkcell::detail
