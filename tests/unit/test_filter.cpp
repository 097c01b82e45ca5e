// Filters: tables against the real power, cutoffs, and what is clamped.
#include "inkcell/filter.hpp"

#include "check.hpp"
#include "font_builder.hpp"
#include "random.hpp"
#include "rounds.hpp"

#if !INKCELL_BOARD_FIRMWARE
#  include <math.h>
#endif

namespace {

using namespace inkcell;

FilterSpec spec(int32_t outside_q10, int32_t inside_q10, uint32_t exponent) {
  return {Q6_10::from_raw(static_cast<int16_t>(outside_q10)),
          Q6_10::from_raw(static_cast<int16_t>(inside_q10)),
          Fixed<uint16_t, 8>::from_raw(static_cast<uint16_t>(exponent))};
}

uint32_t checksum(const Filter& filter) {
  return font_builder::crc32(0, {filter.table, Filter::kEntries});
}

void check_shape(const Filter& filter) {
  CHECK_EQ(filter.coverage(filter.outside_q10), 0);
  CHECK_EQ(filter.coverage(filter.inside_q10), 255);
  CHECK_EQ(filter.coverage(INT32_MIN), 0);
  CHECK_EQ(filter.coverage(INT32_MAX), 255);
  int32_t last = 0;
  for (int32_t d = filter.outside_q10 - 2; d <= filter.inside_q10 + 2; ++d) {
    const int32_t coverage = filter.coverage(d);
    CHECK(coverage >= last);
    last = coverage;
  }
}

#if !INKCELL_BOARD_FIRMWARE

// The table stands for the middle of 256 intervals, so that coverage() may be
// off by half an interval of the ramp, and by the rounding to a level.
void check_power(const FilterSpec& s) {
  const Filter filter = make_filter(s);
  const double exponent = s.exponent.raw / 256.0;
  const double width = filter.inside_q10 - filter.outside_q10;
  for (int i = 0; i < Filter::kEntries; ++i) {
    const double exact = 255 * pow((2 * i + 1) / 512.0, exponent);
    CHECK(fabs(filter.table[i] - exact) <= 0.51);
  }
  for (int32_t d = filter.outside_q10 + 1; d < filter.inside_q10; ++d) {
    const double ramp = (d - filter.outside_q10) / width;
    // What the ramp reaches one and a half intervals away is allowed.
    const double low = ramp < 1.5 / 256 ? 0 : ramp - 1.5 / 256;
    const double high = ramp > 1 - 1.5 / 256 ? 1 : ramp + 1.5 / 256;
    CHECK(filter.coverage(d) >= 255 * pow(low, exponent) - 0.51);
    CHECK(filter.coverage(d) <= 255 * pow(high, exponent) + 0.51);
  }
}

double worst_preset_error(const Filter& filter, double exponent) {
  double worst = 0;
  const double width = filter.inside_q10 - filter.outside_q10;
  for (int32_t d = filter.outside_q10; d <= filter.inside_q10; ++d) {
    const double ramp = (d - filter.outside_q10) / width;
    worst = fmax(worst, fabs(255 * pow(ramp, exponent) - filter.coverage(d)));
  }
  return worst;
}

#endif

}  // namespace

// Filters name what paints outlines with them.
TEST(painters_of_filters) {
  using namespace inkcell::detail;
  CHECK(Filter().band_kind == nullptr);
  CHECK(kFilterArea.band_kind == &kAreaBand);
  CHECK(kFilterText.band_kind == &kPixelRampBand);
  CHECK(kFilterMotion.band_kind == &kWideDistanceBand);
  CHECK(make_filter(spec(-512, 512, 300)).band_kind == &kDistanceBand);
  CHECK(make_filter(spec(-513, 512, 256)).band_kind == &kWideDistanceBand);
  CHECK(make_filter(spec(-512, 513, 256)).band_kind == &kWideDistanceBand);
  const Q6_10 weight = Q6_10::from_raw(1);
  CHECK(with_weight(kFilterText, weight).band_kind == &kWideDistanceBand);
  // Weight needs distances.
  CHECK(with_weight(kFilterArea, weight).band_kind == &kWideDistanceBand);
  CHECK(with_weight(kFilterArea, {}).band_kind == &kPixelRampBand);
  CHECK_EQ(checksum(kFilterArea), checksum(kFilterText));
}

TEST(presets_are_the_same_everywhere) {
  CHECK_EQ(checksum(kFilterText), 0x5e02bce5u);
  CHECK_EQ(checksum(kFilterMotion), 0x5e02bce5u);
  CHECK_EQ(checksum(kFilterPaperDisplay), 0x08493f47u);
  CHECK_EQ(checksum(kFilterPaperBody), 0x08493f47u);
}

TEST(presets_have_their_cutoffs) {
  CHECK_EQ(kFilterText.outside_q10, -512);
  CHECK_EQ(kFilterText.inside_q10, 512);
  CHECK_EQ(kFilterMotion.outside_q10, -614);
  CHECK_EQ(kFilterMotion.inside_q10, 640);
  CHECK_EQ(kFilterPaperDisplay.outside_q10, -768);
  CHECK_EQ(kFilterPaperDisplay.inside_q10, 768);
  CHECK_EQ(kFilterPaperBody.outside_q10, -512);
  CHECK_EQ(kFilterPaperBody.inside_q10, 640);
  check_shape(kFilterText);
  check_shape(kFilterMotion);
  check_shape(kFilterPaperDisplay);
  check_shape(kFilterPaperBody);
  CHECK_EQ(kFilterText.coverage(0), 128);
}

// On the device a table may be built at run time: the same one.
TEST(run_time_tables_equal_compiled_ones) {
  volatile int16_t outside = -768;
  const Filter filter = make_filter(spec(outside, 768, 282));
  CHECK_EQ(checksum(filter), checksum(kFilterPaperDisplay));
  CHECK_EQ(filter.scale, kFilterPaperDisplay.scale);
}

TEST(any_filter_rises) {
  for (Random& random : Rounds(3, 25)) {
    const int32_t outside = random.between(-4096, 4096 - 128);
    check_shape(
        make_filter(spec(outside, random.between(outside + 128, 4096),
                         static_cast<uint32_t>(random.between(64, 1024)))));
  }
}

TEST(values_out_of_range_are_clamped) {
  const Filter wide = make_filter(spec(-32768, 32767, 0));
  CHECK_EQ(wide.outside_q10, -4096);
  CHECK_EQ(wide.inside_q10, 4096);
  CHECK_EQ(checksum(wide), checksum(make_filter(spec(-4096, 4096, 64))));
  const Filter steep = make_filter(spec(0, -5, 65535));
  CHECK_EQ(steep.outside_q10, 0);
  CHECK_EQ(steep.inside_q10, 128);
  CHECK_EQ(checksum(steep), checksum(make_filter(spec(0, 128, 1024))));
  const Filter edge = make_filter(spec(32767, 32767, 256));
  CHECK_EQ(edge.outside_q10, 4096 - 128);
  CHECK_EQ(edge.inside_q10, 4096);
  check_shape(wide);
  check_shape(steep);
  check_shape(edge);
}

TEST(weight_moves_the_edges) {
  const Filter bold = with_weight(kFilterText, Q6_10::from_raw(300));
  CHECK_EQ(bold.outside_q10, -812);
  CHECK_EQ(bold.inside_q10, 212);
  for (int32_t d = -1500; d <= 1500; ++d) {
    CHECK_EQ(bold.coverage(d), kFilterText.coverage(d + 300));
  }
  const Filter light = with_weight(bold, Q6_10::from_raw(-300));
  CHECK_EQ(light.outside_q10, kFilterText.outside_q10);
  CHECK_EQ(light.inside_q10, kFilterText.inside_q10);
  const Filter widest = with_weight(kFilterText, Q6_10::from_raw(32767));
  CHECK_EQ(widest.outside_q10, -4096);
  CHECK_EQ(widest.inside_q10, -4096 + 1024);
  const Filter thinnest = with_weight(kFilterText, Q6_10::from_raw(-32768));
  CHECK_EQ(thinnest.outside_q10, 4096 - 1024);
  CHECK_EQ(thinnest.inside_q10, 4096);
  check_shape(widest);
  check_shape(thinnest);
}

TEST(profiles_rise_alike_on_both_sides) {
  FilterSpec s = spec(-1024, 1024, 256);
  constexpr FilterProfile kCurved[] = {FilterProfile::gaussian,
                                       FilterProfile::sigmoid};
  for (const FilterProfile profile : kCurved) {
    s.profile = profile;
    const Filter filter = make_filter(s);
    check_shape(filter);
    for (int32_t i = 0; i < 128; ++i) {
      const int32_t sum = filter.table[i] + filter.table[255 - i];
      CHECK(sum >= 254 && sum <= 256);
    }
  }
}

TEST(gamma_and_contrast_keep_a_filter_rising) {
  FilterSpec s = spec(-512, 512, 256);
  constexpr uint16_t kGammas[] = {0, 256, 461, 563, 1024, 65535};
  constexpr uint16_t kContrasts[] = {0, 128, 256, 640, 65535};
  constexpr Polarity kPolarities[] = {Polarity::light_on_dark,
                                      Polarity::dark_on_light};
  for (const uint16_t gamma : kGammas) {
    for (const uint16_t contrast : kContrasts) {
      for (const Polarity polarity : kPolarities) {
        s.gamma.raw = gamma;
        s.contrast.raw = contrast;
        s.polarity = polarity;
        check_shape(make_filter(s));
      }
    }
  }
}

#if !INKCELL_BOARD_FIRMWARE

TEST(profiles_follow_their_functions) {
  FilterSpec s = spec(-1024, 1024, 256);
  s.profile = FilterProfile::gaussian;
  const Filter gaussian = make_filter(s);
  s.profile = FilterProfile::sigmoid;
  const Filter sigmoid = make_filter(s);
  const double whole = erf(2.5 / sqrt(2.0));
  for (int i = 0; i < Filter::kEntries; ++i) {
    const double r = (2 * i + 1) / 512.0;
    const double integral = erf((2 * r - 1) * 2.5 / sqrt(2.0)) / whole;
    CHECK(fabs(gaussian.table[i] - 255 * (0.5 + integral / 2)) <= 0.8);
    CHECK(fabs(sigmoid.table[i] - 255 * r * r * (3 - 2 * r)) <= 0.55);
  }
}

// Blended with black and white, coverage shows as much light as it would on a
// display without gamma.
TEST(gamma_shows_the_right_light) {
  FilterSpec s = spec(-512, 512, 256);
  const double gamma = 563 / 256.0;
  s.gamma.raw = 563;
  const Filter light = make_filter(s);
  s.polarity = Polarity::dark_on_light;
  const Filter dark = make_filter(s);
  for (int i = 0; i < Filter::kEntries; ++i) {
    const double covered = (2 * i + 1) / 512.0;
    CHECK(fabs(pow(light.table[i] / 255.0, gamma) - covered) < 0.006);
    CHECK(fabs(pow(1 - dark.table[i] / 255.0, gamma) - (1 - covered)) < 0.006);
  }
}

TEST(contrast_is_the_slope_at_half_coverage) {
  FilterSpec s = spec(-512, 512, 256);
  s.contrast.raw = 512;
  const Filter filter = make_filter(s);
  CHECK_EQ(filter.coverage(-257), 0);
  CHECK_EQ(filter.coverage(257), 255);
  CHECK(fabs(filter.coverage(128) - 255 * 0.75) <= 1.1);
}

TEST(presets_follow_the_power) {
  const struct {
    const Filter& filter;
    double exponent;
  } presets[] = {{kFilterText, 1},
                 {kFilterMotion, 1},
                 {kFilterPaperDisplay, 282 / 256.0},
                 {kFilterPaperBody, 282 / 256.0}};
  double worst = 0;
  for (const auto& preset : presets) {
    worst = fmax(worst, worst_preset_error(preset.filter, preset.exponent));
  }
  // Half a level of rounding, and half an entry's rise: 0.55 level at the
  // steepest place of exponent 1.1.
  CHECK(worst <= 1.05);
  check::write("largest error of presets, 1/1000 level: ");
  check::write_number(static_cast<int64_t>(worst * 1000));
  check::write("\n");
}

TEST(tables_follow_the_power) {
  Random random(8);
  const uint32_t exponents[] = {64, 65, 128, 255, 256, 257, 282, 512, 1024};
  for (const uint32_t exponent : exponents) {
    for (int i = 0; i < 8; ++i) {
      const int32_t outside = random.between(-4096, 4096 - 128);
      check_power(spec(outside, random.between(outside + 128, 4096), exponent));
    }
  }
}

#endif
