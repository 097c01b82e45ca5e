// From signed distance to coverage: cutoffs, contrast and weight in one table.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"

namespace inkcell {

/// What a filter does (the paper, section 4.2.2 and figure 4): coverage is 0
/// at `outside_px` and below, 255 at `inside_px` and above, and between them
/// the linear ramp raised to `exponent`. Both cutoffs within +-4 px, inside
/// above outside by at least 1/8 px; exponent 1/4 to 4. A font's distances are
/// good up to FontRange::band_u on both sides of the edge, 0.75 px at its
/// smallest size: where a filter reaches beyond, coverage ends abruptly.
struct FilterSpec {
  Q6_10 outside_px;
  Q6_10 inside_px;
  Fixed<uint16_t, 8> exponent;  // UQ8.8
};

/// A filter ready for use, 262 bytes: built once, constant afterwards, shared
/// by any number of brushes. The caller owns it; the presets below are ROM.
struct Filter {
  static constexpr int32_t kEntries = 256;

  int16_t outside_q10 = 0;  // [px]
  int16_t inside_q10 = 0;   // [px]
  uint16_t scale = 0;       // entries per 1/1024 px, UQ2.14
  uint8_t table[kEntries] = {};

  /// Coverage of a pixel at a signed distance. [px, Q10]
  constexpr uint8_t coverage(int32_t distance_q10) const noexcept {
    if (distance_q10 <= outside_q10) {
      return 0;
    }
    if (distance_q10 >= inside_q10) {
      return 255;
    }
    return ramp(distance_q10);
  }

  /// The same between the cutoffs: outside_q10 < distance_q10 < inside_q10.
  constexpr uint8_t ramp(int32_t distance_q10) const noexcept {
    const uint32_t step = static_cast<uint32_t>(distance_q10 - outside_q10);
    const uint32_t entry = (step * scale) >> 14;
    return table[entry < kEntries ? entry : kEntries - 1];
  }
};

namespace detail {

// log2 of `value` in 1..65536 (UQ16 with 65536 as one), as a negative Q16
// number: 16 squarings, one bit each.
constexpr int32_t log2_q16(uint32_t value) noexcept {
  int32_t whole = 0;
  uint64_t mantissa = value;
  while (mantissa < 65536) {
    mantissa <<= 1;
    --whole;
  }
  mantissa <<= 14;  // in [2^30, 2^31)
  int32_t fraction = 0;
  for (int bit = 15; bit >= 0; --bit) {
    mantissa = (mantissa * mantissa) >> 30;
    if (mantissa >= (uint64_t{1} << 31)) {
      mantissa >>= 1;
      fraction |= 1 << bit;
    }
  }
  return whole * 65536 + fraction;
}

// 2^(2^-(i + 1)) - the factors of 2^fraction - in UQ2.30.
inline constexpr uint32_t kRootsOfTwo[16] = {
    0x5a82799a, 0x4c1bf829, 0x45cae0f2, 0x42d561b4, 0x4166c34c, 0x40b268fa,
    0x4058f6a8, 0x402c6be9, 0x4016321b, 0x400b1818, 0x40058bce, 0x4002c5d8,
    0x400162e8, 0x4000b173, 0x400058b9, 0x40002c5d};

// 2^exponent for exponent <= 0 in Q16, as UQ16 with 65536 for one.
constexpr uint32_t exp2_q16(int32_t exponent_q16) noexcept {
  const int32_t whole = exponent_q16 >> 16;  // floors: <= 0
  const uint32_t fraction = static_cast<uint32_t>(exponent_q16 & 0xffff);
  uint64_t product = uint64_t{1} << 30;
  for (int i = 0; i < 16; ++i) {
    if ((fraction >> (15 - i)) & 1) {
      product = (product * kRootsOfTwo[i]) >> 30;
    }
  }
  return whole < -30 ? 0 : static_cast<uint32_t>(product >> (14 - whole));
}

}  // namespace detail

/// The table of a filter. Runs at compile time for constants; on a device it
/// costs about 32 products for each of 256 entries, once per style. Values
/// outside the ranges of FilterSpec are clamped to them.
constexpr Filter make_filter(const FilterSpec& spec) noexcept {
  constexpr int32_t kLimit = 4 << 10;
  constexpr int32_t kNarrowest = 1 << 7;
  int32_t outside = spec.outside_px.raw;
  outside = outside < -kLimit ? -kLimit : outside;
  outside = outside > kLimit - kNarrowest ? kLimit - kNarrowest : outside;
  int32_t inside = spec.inside_px.raw;
  inside = inside < outside + kNarrowest ? outside + kNarrowest : inside;
  inside = inside > kLimit ? kLimit : inside;
  int32_t exponent = spec.exponent.raw;
  exponent = exponent < 64 ? 64 : exponent;
  exponent = exponent > 1024 ? 1024 : exponent;

  Filter filter;
  filter.outside_q10 = static_cast<int16_t>(outside);
  filter.inside_q10 = static_cast<int16_t>(inside);
  filter.scale =
      static_cast<uint16_t>((Filter::kEntries << 14) / (inside - outside));
  for (int32_t i = 0; i < Filter::kEntries; ++i) {
    // An entry stands for the middle of its interval.
    const uint32_t ramp = static_cast<uint32_t>(2 * i + 1) << 7;  // of 65536
    const int32_t log2 = detail::log2_q16(ramp);
    const int32_t power =
        static_cast<int32_t>((static_cast<int64_t>(log2) * exponent) >> 8);
    filter.table[i] =
        static_cast<uint8_t>((detail::exp2_q16(power) * 255 + 32768) >> 16);
  }
  return filter;
}

/// -0.5 to 0.5 px, exponent 1: right weight at text sizes. The default.
inline constexpr Filter kFilterText =
    make_filter({Q6_10::from_raw(-512), Q6_10::from_raw(512),
                 Fixed<uint16_t, 8>::from_raw(256)});

/// -0.6 to 0.625 px, exponent 1: calm, for type that moves.
inline constexpr Filter kFilterMotion =
    make_filter({Q6_10::from_raw(-614), Q6_10::from_raw(640),
                 Fixed<uint16_t, 8>::from_raw(256)});

/// -0.75 to 0.75 px, exponent 1.1: the paper's choice for display type.
inline constexpr Filter kFilterPaperDisplay =
    make_filter({Q6_10::from_raw(-768), Q6_10::from_raw(768),
                 Fixed<uint16_t, 8>::from_raw(282)});

/// -0.5 to 0.625 px, exponent 1.1: the paper's choice for body type.
inline constexpr Filter kFilterPaperBody =
    make_filter({Q6_10::from_raw(-512), Q6_10::from_raw(640),
                 Fixed<uint16_t, 8>::from_raw(282)});

}  // namespace inkcell
