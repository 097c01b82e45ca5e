// From signed distance to coverage: cutoffs, contrast and weight in one table.
// kFilterArea, the default of styles, takes exact areas of outlines instead;
// its table is for fields and effects.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"

namespace inkcell {

/// How coverage rises between the cutoffs: from 0 to 1 as r goes from 0 to 1.
enum class FilterProfile : uint8_t {
  linear,    // r: what a straight edge covers of a pixel, at +-0.5 px
  gaussian,  // a Gaussian's integral, 2.5 sigma to each side
  sigmoid,   // r r (3 - 2 r)
};

/// Which of text and background is the lighter.
enum class Polarity : uint8_t { light_on_dark, dark_on_light };

/// What a filter does (the paper, section 4.2.2 and figure 4): coverage is 0 at
/// `outside_px` and below, 255 at `inside_px` and above, and between them the
/// profile raised to `exponent`. Both cutoffs within +-4 px, inside above
/// outside by at least 1/8 px; exponent 1/4 to 4. A font's distances are good
/// within its band: see check_reach in shadow.hpp.
///
/// Sinks blend the numbers that displays take, which are light to the power of
/// 1 / gamma. With the display's `gamma`, 1 (off) to 4, white text on black or
/// black text on white shows as much light as coverage says; colours between
/// need less. `contrast`, 1/4 to 4, is the slope at half coverage, before that.
struct FilterSpec {
  Q6_10 outside_px;
  Q6_10 inside_px;
  Fixed<uint16_t, 8> exponent = Fixed<uint16_t, 8>::from_int(1);
  FilterProfile profile = FilterProfile::linear;
  Fixed<uint16_t, 8> contrast = Fixed<uint16_t, 8>::from_int(1);
  Fixed<uint16_t, 8> gamma = Fixed<uint16_t, 8>::from_int(1);
  Polarity polarity = Polarity::light_on_dark;
};

namespace detail {
struct BandKind;

// What a filter takes. A program links the painters of outlines of the filters
// that it names, and none if it opens fonts of fields alone.
extern const BandKind kPixelRampBand;     // Filter::is_linear_pixel()
extern const BandKind kDistanceBand;      // up to half a pixel
extern const BandKind kWideDistanceBand;  // any filter
extern const BandKind kAreaBand;          // kFilterArea
}  // namespace detail

/// A filter ready for use, 268 bytes: built once, constant afterwards, shared
/// by any number of styles. The caller owns it; the presets below are ROM. An
/// empty one draws nothing.
struct Filter {
  static constexpr int32_t kEntries = 256;

  const detail::BandKind* band_kind = nullptr;
  int16_t outside_q10 = 0;  // [px]
  int16_t inside_q10 = 0;   // [px]
  uint16_t scale = 0;       // entries per 1/1024 px, UQ2.14
  uint8_t table[kEntries] = {};
  bool is_linear = false;  // the table is a straight line from 0 to 255

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

  /// Whether coverage is what a straight edge covers of a pixel, the ramp of
  /// the `text` filter.
  constexpr bool is_linear_pixel() const noexcept {
    return is_linear && outside_q10 == -512 && inside_q10 == 512;
  }

  /// coverage() for outside_q10 < distance_q10 < inside_q10. Other distances
  /// have no meaning, but never read outside the table.
  constexpr uint8_t ramp(int32_t distance_q10) const noexcept {
    const uint32_t step = static_cast<uint32_t>(distance_q10 - outside_q10);
    return table[static_cast<uint8_t>((step * scale) >> 14)];
  }

  /// Moves the cutoffs, and selects the kind of band anew. [px]
  constexpr void set_cutoffs(int32_t outside, int32_t inside) noexcept {
    outside_q10 = static_cast<int16_t>(outside);
    inside_q10 = static_cast<int16_t>(inside);
    band_kind = is_linear_pixel()                  ? &detail::kPixelRampBand
                : outside >= -512 && inside <= 512 ? &detail::kDistanceBand
                                                   : &detail::kWideDistanceBand;
  }

  /// Moves the edges of the text outwards: see with_weight().
  constexpr void add_weight(Q6_10 weight_px) noexcept {
    constexpr int32_t kLimit = 4 << 10;
    const int32_t weight =
        detail::clamp(weight_px.raw, inside_q10 - kLimit, outside_q10 + kLimit);
    set_cutoffs(outside_q10 - weight, inside_q10 - weight);
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

// value^exponent, both 0 to 1. [UQ16 with 65536 for one, Q8]
constexpr int32_t power_q16(int32_t value_q16, int32_t exponent_q8) noexcept {
  if (value_q16 <= 0) {
    return 0;
  }
  const int32_t log2 = log2_q16(static_cast<uint32_t>(value_q16));
  const auto power =
      static_cast<int32_t>((static_cast<int64_t>(log2) * exponent_q8) >> 8);
  return static_cast<int32_t>(exp2_q16(power));
}

// The upper half of the Gaussian profile at 0, 1/16 ... 1 of it. [UQ16]
inline constexpr int32_t kGaussian[17] = {
    32768, 36888, 40908, 44738, 48297, 51526, 54385, 56855, 58937,
    60651, 62027, 63106, 63931, 64547, 64996, 65315, 65536};

// The profile at `ramp_q16`, 0 to 65536.
constexpr int32_t profile_q16(FilterProfile profile,
                              int32_t ramp_q16) noexcept {
  if (profile == FilterProfile::sigmoid) {
    const int64_t square = (int64_t{ramp_q16} * ramp_q16) >> 16;
    return static_cast<int32_t>((square * (3 * 65536 - 2 * ramp_q16)) >> 16);
  }
  if (profile == FilterProfile::gaussian) {
    const bool is_upper = ramp_q16 >= 32768;
    const int32_t way = is_upper ? ramp_q16 - 32768 : 32768 - ramp_q16;
    const int32_t i = way >> 11 < 15 ? way >> 11 : 15;
    const int32_t step = kGaussian[i + 1] - kGaussian[i];
    const int32_t upper = kGaussian[i] + ((step * (way - i * 2048)) >> 11);
    return is_upper ? upper : 65536 - upper;
  }
  return ramp_q16;
}

}  // namespace detail

/// The table of a filter. Runs at compile time for constants; on a device it
/// costs about 32 products for each of 256 entries, once per style. Values
/// outside the ranges of FilterSpec are clamped to them.
constexpr Filter make_filter(const FilterSpec& spec) noexcept {
  constexpr int32_t kLimit = 4 << 10;
  constexpr int32_t kNarrowest = 1 << 7;
  constexpr int32_t kOne = 1 << 8;
  using detail::clamp;
  const int32_t outside =
      clamp(spec.outside_px.raw, -kLimit, kLimit - kNarrowest);
  const int32_t inside =
      clamp(spec.inside_px.raw, outside + kNarrowest, kLimit);
  const int32_t exponent = clamp(spec.exponent.raw, kOne / 4, 4 * kOne);
  const int32_t contrast = clamp(spec.contrast.raw, kOne / 4, 4 * kOne);
  const int32_t gamma = clamp(spec.gamma.raw, kOne, 4 * kOne);

  Filter filter;
  filter.is_linear = spec.profile == FilterProfile::linear &&
                     exponent == kOne && contrast == kOne && gamma == kOne;
  filter.set_cutoffs(outside, inside);
  filter.scale =
      static_cast<uint16_t>((Filter::kEntries << 14) / (inside - outside));
  for (int32_t i = 0; i < Filter::kEntries; ++i) {
    // An entry stands for the middle of its interval.
    const int32_t ramp = (2 * i + 1) << 7;  // of 65536
    int32_t light =
        detail::power_q16(detail::profile_q16(spec.profile, ramp), exponent);
    if (contrast != kOne) {
      light = clamp(32768 + (light - 32768) * contrast / kOne, 0, 65536);
    }
    if (gamma != kOne) {
      const int32_t inverse = kOne * kOne / gamma;
      light = spec.polarity == Polarity::light_on_dark
                  ? detail::power_q16(light, inverse)
                  : 65536 - detail::power_q16(65536 - light, inverse);
    }
    filter.table[i] = static_cast<uint8_t>((light * 255 + 32768) >> 16);
  }
  return filter;
}

/// The same filter with the edges of the text moved outwards by `weight_px`,
/// inwards if it is negative: strokes gain twice that. Cutoffs are clamped to
/// +-4 px, so the full weight may not be reached. Glyphs of fields are as fast
/// to draw with it. The weight of kFilterArea is that of kFilterText.
constexpr Filter with_weight(const Filter& filter, Q6_10 weight_px) noexcept {
  Filter result = filter;
  result.add_weight(weight_px);
  return result;
}

/// -0.5 to 0.5 px, exponent 1: right weight at text sizes.
inline constexpr Filter kFilterText =
    make_filter({Q6_10::from_raw(-512), Q6_10::from_raw(512)});

/// -0.6 to 0.625 px, exponent 1: calm, for type that moves.
inline constexpr Filter kFilterMotion =
    make_filter({Q6_10::from_raw(-614), Q6_10::from_raw(640)});

/// -0.75 to 0.75 px, exponent 1.1: the paper's choice for display type.
inline constexpr Filter kFilterPaperDisplay =
    make_filter({Q6_10::from_raw(-768), Q6_10::from_raw(768),
                 Fixed<uint16_t, 8>::from_raw(282)});

/// -0.5 to 0.625 px, exponent 1.1: the paper's choice for body type.
inline constexpr Filter kFilterPaperBody =
    make_filter({Q6_10::from_raw(-512), Q6_10::from_raw(640),
                 Fixed<uint16_t, 8>::from_raw(282)});

namespace detail {
constexpr Filter make_area_filter() noexcept {
  Filter filter = kFilterText;
  filter.band_kind = &kAreaBand;
  return filter;
}
}  // namespace detail

/// Exact coverage: how much of each pixel lies inside, so that ink and weight
/// are the same at every position. The default of styles. For outlines; glyphs
/// of fields and effects take the ramp of a straight edge, as with kFilterText.
inline constexpr Filter kFilterArea = detail::make_area_filter();

}  // namespace inkcell
