// Styles: which sizes and directions are allowed, and their steps.
#include "inkcell/style.hpp"

#include "check.hpp"
#include "random.hpp"

namespace {

using namespace inkcell;

Status make(int32_t size_q6, Style& out) {
  return Style::make(Q26_6::from_raw(size_q6), kFilterMotion, out);
}

Direction direction(int32_t cosine_q30, int32_t sine_q30) {
  return {Fixed<int32_t, 30>::from_raw(cosine_q30),
          Fixed<int32_t, 30>::from_raw(sine_q30)};
}

Status turn(int32_t cosine_q30, int32_t sine_q30) {
  Style style;
  const Status status = Style::make(Q26_6::from_int(20), kFilterText,
                                    direction(cosine_q30, sine_q30), style);
  CHECK_EQ(style.size().raw, status == Status::ok ? 20 * 64 : 16 * 64);
  return status;
}

constexpr int32_t kOne = 1 << 30;

}  // namespace

TEST(default_style) {
  const Style style{};
  CHECK_EQ(style.size().raw, 16 * 64);
  CHECK(style.is_upright());
  CHECK_EQ(style.step_along_q16(), 64 << 16);
  CHECK_EQ(style.step_across_q16(), 0);
  CHECK(&style.filter() == &kFilterText);
  CHECK_EQ(style.to_px_q10(64 << 10), 1 << 10);
  Style made;
  CHECK_OK(Style::make(Q26_6::from_int(16), kFilterText, made));
  CHECK_EQ(made.step_along_q16(), style.step_along_q16());
  const int32_t far = made.to_px_q10(INT32_MAX);
  CHECK_EQ(style.to_px_q10(INT32_MAX), far);
  CHECK_EQ(style.to_px_q10(INT32_MIN), made.to_px_q10(INT32_MIN));
}

TEST(sizes_from_4_to_1024_px) {
  Style style;
  CHECK_EQ(make(0, style), Status::bad_argument);
  CHECK_EQ(make(-64, style), Status::bad_argument);
  CHECK_EQ(make(INT32_MIN, style), Status::bad_argument);
  CHECK_EQ(make(INT32_MAX, style), Status::bad_argument);
  CHECK_EQ(make(4 * 64 - 1, style), Status::bad_argument);
  CHECK_EQ(make(1024 * 64 + 1, style), Status::bad_argument);
  CHECK(&style.filter() == &kFilterText);  // untouched
  CHECK_OK(make(4 * 64, style));
  CHECK_EQ(style.step_along_q16(), 256 << 16);
  CHECK_OK(make(1024 * 64, style));
  CHECK_EQ(style.step_along_q16(), 1 << 16);
  CHECK(&style.filter() == &kFilterMotion);
  for (int32_t size = 4 * 64; size <= 1024 * 64; ++size) {
    CHECK_OK(make(size, style));
    const int64_t whole = int64_t{style.step_along_q16()} * size;
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
  Style style;
  CHECK_OK(Style::make(kMinSize, kFilterText, direction(-kOne, 0), style));
  CHECK(!style.is_upright());
  CHECK_EQ(style.step_along_q16(), -(256 << 16));
  CHECK_OK(Style::make(kMinSize, kFilterText, direction(0, kOne), style));
  CHECK(!style.is_upright());
  CHECK_EQ(style.step_along_q16(), 0);
  CHECK_EQ(style.step_across_q16(), 256 << 16);
  CHECK_OK(Style::make(kMinSize, kFilterText, direction(kOne, 1), style));
  CHECK(!style.is_upright());
}

// Within the clamp the product is exact; beyond it 32 px is reached.
TEST(distances_scale_and_clamp) {
  Random random(4);
  const int32_t sizes[] = {4 * 64, 4 * 64 + 1,  16 * 64,
                           1000,   64 * 64 - 1, 1024 * 64};
  for (const int32_t size : sizes) {
    Style style;
    CHECK_OK(make(size, style));
    for (int i = 0; i < 200; ++i) {
      const int32_t distance = random.between(-(1024 << 10), 1024 << 10);
      const int64_t exact = (int64_t{distance} * size) >> 16;
      const int32_t found = style.to_px_q10(distance);
      if (exact > -32700 && exact < 32700) {
        CHECK_EQ(found, exact);
      } else {
        CHECK(found >= INT16_MIN && found <= INT16_MAX);
        CHECK(found > 0 ? found >= 32700 : found <= -32700);
      }
    }
    CHECK_EQ(style.to_px_q10(INT32_MIN), style.to_px_q10(-(1 << 30)));
    CHECK_EQ(style.to_px_q10(INT32_MAX), style.to_px_q10(1 << 30));
  }
}
