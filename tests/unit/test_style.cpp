// Styles: which sizes and directions are allowed, and their steps.
#include "inkcell/style.hpp"

#include "check.hpp"
#include "place/style_parts.hpp"
#include "random.hpp"

namespace {

using namespace inkcell;

Style style_of(int32_t size_q6) {
  return Style(Q26_6::from_raw(size_q6), kFilterMotion);
}

Direction direction(int32_t cosine_q30, int32_t sine_q30) {
  return {Fixed<int32_t, 30>::from_raw(cosine_q30),
          Fixed<int32_t, 30>::from_raw(sine_q30)};
}

Direction turned_to(int32_t cosine_q30, int32_t sine_q30) {
  return Style(20_px, kFilterText, direction(cosine_q30, sine_q30)).direction();
}

// Whether the direction of a style is what was asked for.
bool is_kept(int32_t cosine_q30, int32_t sine_q30) {
  const Direction found = turned_to(cosine_q30, sine_q30);
  return found.cosine.raw == cosine_q30 && found.sine.raw == sine_q30;
}

bool is_near(Direction found, double cosine, double sine) {
  constexpr double kNear = 1e-6;
  const double x = found.cosine.raw / 1073741824.0 - cosine;
  const double y = found.sine.raw / 1073741824.0 - sine;
  return x < kNear && x > -kNear && y < kNear && y > -kNear;
}

constexpr int32_t kOne = 1 << 30;

}  // namespace

// Styles are constants.
constexpr Style kPlain;
constexpr Style kTitle = Style(24_px, kFilterText);
static_assert(kTitle.is_upright());

TEST(default_style) {
  CHECK_EQ(kPlain.size().raw, 16 * 64);
  CHECK(kPlain.is_upright());
  CHECK_EQ(kPlain.right().x_q16, 64 << 16);
  CHECK_EQ(kPlain.up().x_q16, 0);
  CHECK(&kPlain.filter() == &kFilterArea);
  CHECK(detail::StyleParts::band_kind(kPlain) == &detail::kAreaBand);
  CHECK_EQ(kPlain.to_px_q10(64 << 10), 1 << 10);
  CHECK_EQ(kTitle.size().raw, 24 * 64);
  CHECK(&kTitle.filter() == &kFilterText);
  CHECK(is_same(kTitle, Style(24_px, kFilterText)));
  CHECK(!is_same(kTitle, Style(24_px)));
}

TEST(sizes_are_clamped_to_4_to_1024_px) {
  const int32_t small[] = {0, -64, INT32_MIN, 4 * 64 - 1, 4 * 64};
  for (const int32_t size : small) {
    CHECK_EQ(style_of(size).size().raw, 4 * 64);
    CHECK_EQ(style_of(size).right().x_q16, 256 << 16);
  }
  const int32_t large[] = {1024 * 64, 1024 * 64 + 1, INT32_MAX};
  for (const int32_t size : large) {
    CHECK_EQ(style_of(size).size().raw, 1024 * 64);
    CHECK_EQ(style_of(size).right().x_q16, 1 << 16);
  }
  for (int32_t size = 4 * 64; size <= 1024 * 64; ++size) {
    const Style style = style_of(size);
    CHECK_EQ(style.size().raw, size);
    const int64_t whole = int64_t{style.right().x_q16} * size;
    CHECK(whole <= int64_t{1} << 32 && whole > (int64_t{1} << 32) - size);
  }
}

TEST(unit_vectors_are_kept) {
  CHECK(is_kept(kOne, 0));
  CHECK(is_kept(0, kOne));
  CHECK(is_kept(-kOne, 0));
  CHECK(is_kept(0, -kOne));
  CHECK(is_kept(759250125, 759250125));
  CHECK(is_kept(kOne / 5 * 3, -kOne / 5 * 4));
  CHECK(is_kept(0, kOne - kOne / 1001));
  CHECK(is_kept(0, kOne + kOne / 1001));
}

TEST(other_vectors_are_brought_to_unit_length) {
  CHECK(is_near(turned_to(0, kOne - kOne / 999), 0, 1));
  CHECK(is_near(turned_to(0, kOne + kOne / 999), 0, 1));
  CHECK(is_near(turned_to(0, 1), 0, 1));
  CHECK(is_near(turned_to(0, INT32_MIN), 0, -1));
  CHECK(is_near(turned_to(-3, 4), -0.6, 0.8));
  CHECK(is_near(turned_to(INT32_MAX / 5 * 3, INT32_MAX / 5 * 4), 0.6, 0.8));
  const double half = 0.70710678118654752;
  CHECK(is_near(turned_to(kOne, kOne), half, half));
  CHECK(is_near(turned_to(INT32_MIN, INT32_MIN), -half, -half));
  CHECK(is_near(turned_to(INT32_MAX, INT32_MAX), half, half));
  CHECK(is_near(turned_to(kOne / 2, kOne / 2 - 1), half, half));
}

TEST(no_direction_is_upright) {
  CHECK(is_kept(kOne, 0));
  const Direction nowhere = direction(0, 0);
  CHECK(is_same(Style(kMinSize, kFilterText, nowhere),
                Style(kMinSize, kFilterText)));
  const Direction far = direction(INT32_MAX, 0);
  CHECK(Style(kMinSize, kFilterText, far).is_upright());
}

TEST(upright_is_to_the_right) {
  Style style(kMinSize, kFilterText, direction(-kOne, 0));
  CHECK(!style.is_upright());
  CHECK_EQ(style.right().x_q16, -(256 << 16));
  style = Style(kMinSize, kFilterText, direction(0, kOne));
  CHECK(!style.is_upright());
  CHECK_EQ(style.right().x_q16, 0);
  CHECK_EQ(style.up().x_q16, 256 << 16);
  style = Style(kMinSize, kFilterText, direction(kOne, 1));
  CHECK(!style.is_upright());
}

// Within the clamp the product is exact; beyond it 32 px is reached.
TEST(distances_scale_and_clamp) {
  Random random(4);
  const int32_t sizes[] = {4 * 64, 4 * 64 + 1,  16 * 64,
                           1000,   64 * 64 - 1, 1024 * 64};
  for (const int32_t size : sizes) {
    const Style style = style_of(size);
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
