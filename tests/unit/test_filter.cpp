// Filters: tables against the real power, cutoffs, and what is clamped.
#include "inkcell/filter.hpp"

#include "check.hpp"
#include "font_builder.hpp"
#include "random.hpp"

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
  Random random(3);
  for (int i = 0; i < 25; ++i) {
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

#if !INKCELL_BOARD_FIRMWARE

TEST(presets_follow_the_power) {
  struct Preset {
    const Filter& filter;
    double exponent;
  };
  const Preset presets[] = {{kFilterText, 1},
                            {kFilterMotion, 1},
                            {kFilterPaperDisplay, 282 / 256.0},
                            {kFilterPaperBody, 282 / 256.0}};
  double worst = 0;
  for (const Preset& preset : presets) {
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
