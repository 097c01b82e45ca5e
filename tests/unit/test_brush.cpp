// Brushes: which sizes and directions are allowed, and their steps.
#include "inkcell/brush.hpp"

#include "check.hpp"
#include "random.hpp"

namespace {

using namespace inkcell;

Status make(int32_t size_q6, Brush& out) {
  return Brush::make(Q26_6::from_raw(size_q6), kFilterMotion, out);
}

Direction direction(int32_t cosine_q30, int32_t sine_q30) {
  return {Fixed<int32_t, 30>::from_raw(cosine_q30),
          Fixed<int32_t, 30>::from_raw(sine_q30)};
}

Status turn(int32_t cosine_q30, int32_t sine_q30) {
  Brush brush;
  const Status status = Brush::make(Q26_6::from_int(20), kFilterText,
                                    direction(cosine_q30, sine_q30), brush);
  CHECK_EQ(brush.size().raw, status == Status::ok ? 20 * 64 : 16 * 64);
  return status;
}

constexpr int32_t kOne = 1 << 30;

}  // namespace

TEST(default_brush) {
  const Brush brush;
  CHECK_EQ(brush.size().raw, 16 * 64);
  CHECK(brush.is_upright());
  CHECK_EQ(brush.step_along_q16(), 64 << 16);
  CHECK_EQ(brush.step_across_q16(), 0);
  CHECK(&brush.filter() == &kFilterText);
  CHECK_EQ(brush.to_px_q10(64 << 10), 1 << 10);
  Brush made;
  CHECK_OK(Brush::make(Q26_6::from_int(16), kFilterText, made));
  CHECK_EQ(made.step_along_q16(), brush.step_along_q16());
  const int32_t far = made.to_px_q10(INT32_MAX);
  CHECK_EQ(brush.to_px_q10(INT32_MAX), far);
  CHECK_EQ(brush.to_px_q10(INT32_MIN), made.to_px_q10(INT32_MIN));
}

TEST(sizes_from_4_to_1024_px) {
  Brush brush;
  CHECK_EQ(make(0, brush), Status::bad_argument);
  CHECK_EQ(make(-64, brush), Status::bad_argument);
  CHECK_EQ(make(INT32_MIN, brush), Status::bad_argument);
  CHECK_EQ(make(INT32_MAX, brush), Status::bad_argument);
  CHECK_EQ(make(4 * 64 - 1, brush), Status::bad_argument);
  CHECK_EQ(make(1024 * 64 + 1, brush), Status::bad_argument);
  CHECK(&brush.filter() == &kFilterText);  // untouched
  CHECK_OK(make(4 * 64, brush));
  CHECK_EQ(brush.step_along_q16(), 256 << 16);
  CHECK_OK(make(1024 * 64, brush));
  CHECK_EQ(brush.step_along_q16(), 1 << 16);
  CHECK(&brush.filter() == &kFilterMotion);
  for (int32_t size = 4 * 64; size <= 1024 * 64; ++size) {
    CHECK_OK(make(size, brush));
    const int64_t whole = int64_t{brush.step_along_q16()} * size;
    CHECK(whole <= int64_t{1} << 32 && whole > (int64_t{1} << 32) - size);
  }
}

TEST(directions_are_unit_vectors) {
  CHECK_OK(turn(kOne, 0));
  CHECK_OK(turn(0, kOne));
  CHECK_OK(turn(-kOne, 0));
  CHECK_OK(turn(0, -kOne));
  CHECK_OK(turn(759250125, 759250125));
  CHECK_OK(turn(kOne / 5 * 3, -kOne / 5 * 4));
  CHECK_OK(turn(kOne - kOne / 1001, 0));
  CHECK_OK(turn(kOne + kOne / 1001, 0));
  CHECK_EQ(turn(kOne - kOne / 999, 0), Status::bad_argument);
  CHECK_EQ(turn(kOne + kOne / 999, 0), Status::bad_argument);
  CHECK_EQ(turn(0, 0), Status::bad_argument);
  CHECK_EQ(turn(kOne, kOne), Status::bad_argument);
  CHECK_EQ(turn(INT32_MIN, INT32_MIN), Status::bad_argument);
  CHECK_EQ(turn(INT32_MAX, INT32_MAX), Status::bad_argument);
}

TEST(upright_is_to_the_right) {
  Brush brush;
  CHECK_OK(Brush::make(kMinSize, kFilterText, direction(-kOne, 0), brush));
  CHECK(!brush.is_upright());
  CHECK_EQ(brush.step_along_q16(), -(256 << 16));
  CHECK_OK(Brush::make(kMinSize, kFilterText, direction(0, kOne), brush));
  CHECK(!brush.is_upright());
  CHECK_EQ(brush.step_along_q16(), 0);
  CHECK_EQ(brush.step_across_q16(), 256 << 16);
  CHECK_OK(Brush::make(kMinSize, kFilterText, direction(kOne, 1), brush));
  CHECK(!brush.is_upright());
}

// Within the clamp the product is exact; beyond it 32 px is reached.
TEST(distances_scale_and_clamp) {
  Random random(4);
  const int32_t sizes[] = {4 * 64, 4 * 64 + 1,  16 * 64,
                           1000,   64 * 64 - 1, 1024 * 64};
  for (const int32_t size : sizes) {
    Brush brush;
    CHECK_OK(make(size, brush));
    for (int i = 0; i < 200; ++i) {
      const int32_t distance = random.between(-(1024 << 10), 1024 << 10);
      const int64_t exact = (int64_t{distance} * size) >> 16;
      const int32_t found = brush.to_px_q10(distance);
      if (exact > -32700 && exact < 32700) {
        CHECK_EQ(found, exact);
      } else {
        CHECK(found >= INT16_MIN && found <= INT16_MAX);
        CHECK(found > 0 ? found >= 32700 : found <= -32700);
      }
    }
    CHECK_EQ(brush.to_px_q10(INT32_MIN), brush.to_px_q10(-(1 << 30)));
    CHECK_EQ(brush.to_px_q10(INT32_MAX), brush.to_px_q10(1 << 30));
  }
}

// The quick form of coverage is the plain one at every distance near the
// cutoffs, where it decides, and at some far away.
TEST(coverage_equals_the_plain_chain) {
  Random random(5);
  const Filter* filters[] = {&kFilterText, &kFilterMotion, &kFilterPaperDisplay,
                             &kFilterPaperBody};
  const int32_t sizes[] = {4 * 64, 4 * 64 + 1,  16 * 64,
                           1000,   64 * 64 - 1, 1024 * 64};
  for (const Filter* filter : filters) {
    for (const int32_t size : sizes) {
      Brush brush;
      CHECK_OK(Brush::make(Q26_6::from_raw(size), *filter, brush));
      const int32_t px_u_q10 = (1 << 26) / size;
      for (int i = 0; i < 1000; ++i) {
        const int32_t reach = i % 4 == 0 ? 1024 << 10 : px_u_q10;
        const int32_t distance = random.between(-reach, reach);
        const uint8_t plain = filter->coverage(brush.to_px_q10(distance));
        CHECK_EQ(brush.coverage(distance), plain);
        CHECK(!brush.is_transparent(distance) || plain == 0);
        CHECK(!brush.is_opaque(distance) || plain == 255);
      }
    }
  }
}

TEST(cutoffs_are_those_of_the_filter) {
  const Filter* filters[] = {&kFilterText, &kFilterMotion, &kFilterPaperDisplay,
                             &kFilterPaperBody};
  for (const Filter* filter : filters) {
    for (int32_t size = 4 * 64; size <= 1024 * 64; size += size / 16 + 1) {
      Brush brush;
      CHECK_OK(Brush::make(Q26_6::from_raw(size), *filter, brush));
      const auto px_q10 = [&brush](int32_t u_q10) {
        return (u_q10 * brush.size().raw) >> 16;
      };
      const int32_t transparent = brush.transparent_u_q10();
      CHECK(px_q10(transparent) <= filter->outside_q10);
      CHECK(px_q10(transparent + 1) > filter->outside_q10);
      const int32_t opaque = brush.opaque_u_q10();
      CHECK(px_q10(opaque) >= filter->inside_q10);
      CHECK(px_q10(opaque - 1) < filter->inside_q10);
    }
  }
  const Brush brush;
  CHECK(brush.is_transparent(-32705) && !brush.is_transparent(-32704));
  CHECK(brush.is_opaque(32768) && !brush.is_opaque(32767));
}
