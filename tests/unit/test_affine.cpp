// Styles of any matrix: which are allowed, and what their steps are.
#include "check.hpp"
#include "inkcell/style.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;

// In px to the em: rows as the screen has them.
struct Map {
  double x_right;
  double y_right;
  double x_up;
  double y_up;
};

double magnitude(double value) {
  return value < 0 ? -value : value;
}

Q16_16 entry(double px) {
  return Q16_16::from_raw(static_cast<int32_t>(px * 65536));
}

Matrix matrix_of(const Map& map) {
  return {entry(map.x_right), entry(map.x_up), entry(map.y_right),
          entry(map.y_up)};
}

// The map that a matrix holds exactly.
Map map_of(const Matrix& matrix) {
  return {matrix.x_right.raw / 65536.0, matrix.y_right.raw / 65536.0,
          matrix.x_up.raw / 65536.0, matrix.y_up.raw / 65536.0};
}

Status make(const Map& map, Style& out) {
  return Style::make(matrix_of(map), kFilterText, out);
}

// A unit vector in any direction.
struct Turn {
  double cosine;
  double sine;

  explicit Turn(Random& random) {
    const double t = random.between(-1000, 1000) / 1000.0;
    const double sign = (random.next() & 1) != 0 ? 1 : -1;
    cosine = sign * (1 - t * t) / (1 + t * t);
    sine = sign * 2 * t / (1 + t * t);
    if ((random.next() & 1) != 0) {
      const double old = cosine;
      cosine = -sine;
      sine = old;
    }
  }
};

// A turn, a stretch of the axes, and another turn.
Map any_map(Random& random, double most_px, double least_px) {
  const Turn first(random);
  const Turn last(random);
  const double sign = (random.next() & 1) != 0 ? 1 : -1;
  const double x_right = most_px * first.cosine;
  const double y_right = -most_px * first.sine;
  const double x_up = sign * least_px * first.sine;
  const double y_up = sign * least_px * first.cosine;
  return {last.cosine * x_right - last.sine * x_up,
          last.cosine * y_right - last.sine * y_up,
          last.sine * x_right + last.cosine * x_up,
          last.sine * y_right + last.cosine * y_up};
}

}  // namespace

TEST(matrices_have_stretches_within_the_sizes) {
  Style style;
  CHECK_EQ(make({0, 0, 0, 0}, style), Status::bad_argument);
  CHECK_EQ(make({24, 24, 24, 24}, style), Status::bad_argument);
  CHECK_EQ(make({3.9, 0, 0, 24}, style), Status::bad_argument);
  CHECK_EQ(make({24, 0, 0, 1025}, style), Status::bad_argument);
  CHECK_EQ(make({800, 800, -800, 800}, style), Status::bad_argument);
  CHECK_EQ(make({24, 1000, 0, 24}, style), Status::bad_argument);
  const int32_t ends[] = {INT32_MIN, INT32_MAX};
  for (const int32_t a : ends) {
    for (const int32_t b : ends) {
      const Matrix far = {Q16_16::from_raw(a), Q16_16::from_raw(b),
                          Q16_16::from_raw(b), Q16_16::from_raw(a)};
      CHECK_EQ(Style::make(far, kFilterText, style), Status::bad_argument);
    }
  }
  CHECK_EQ(style.size().raw, 16 << 6);  // untouched
  CHECK_OK(make({4, 0, 0, 1024}, style));
  CHECK_EQ(style.size().raw, 1024 << 6);
  CHECK_EQ(style.least_gain_q15(), 1 << 7);
  CHECK_OK(make({0, -4, 4, 0}, style));
  CHECK(!style.is_stretched());
  CHECK_OK(make({-1024, 0, 0, 4}, style));
  CHECK_OK(make({20, 8, 0, 20}, style));
  CHECK(style.is_stretched());
  CHECK(!style.is_upright());
}

// Entries whose squares would wrap to those of a size of about 24 px.
TEST(huge_matrices_do_not_pass_for_small_ones) {
  constexpr int32_t kPx24 = 24 << 16;
  constexpr int32_t kFar[] = {INT32_MIN, INT32_MAX};
  for (const int32_t far : kFar) {
    Style style;
    const Matrix matrix = {Q16_16::from_raw(far), Q16_16::from_raw(kPx24),
                           Q16_16::from_raw(-kPx24), Q16_16::from_raw(far)};
    CHECK_EQ(Style::make(matrix, kFilterText, style), Status::bad_argument);
  }
}

TEST(stretches_are_rounded_to_1_64_px) {
  const auto make_raw = [](int32_t most_q16, int32_t least_q16) {
    Style style;
    return Style::make(
        {Q16_16::from_raw(most_q16), {}, {}, Q16_16::from_raw(least_q16)},
        kFilterText, style);
  };
  CHECK_OK(make_raw((1024 << 16) + 511, (4 << 16) - 512));
  CHECK_EQ(make_raw((1024 << 16) + 512, 4 << 16), Status::bad_argument);
  CHECK_EQ(make_raw(1024 << 16, (4 << 16) - 513), Status::bad_argument);
}

TEST(stretches_within_1_1024_are_alike) {
  constexpr int32_t kMost = 64 << 16;
  constexpr int32_t kPart = kMost / 1024;
  Style style;
  Matrix matrix;
  matrix.x_right.raw = kMost;
  matrix.y_up.raw = kMost - kPart;
  CHECK_OK(Style::make(matrix, kFilterText, style));
  CHECK(!style.is_upright() && !style.is_stretched());
  matrix.y_up.raw = kMost - kPart - 1;
  CHECK_OK(Style::make(matrix, kFilterText, style));
  CHECK(style.is_stretched());
  // Where the size is rounded down the least stretch may be greater.
  matrix.x_right.raw = (4 << 16) + 511;
  matrix.y_up.raw = matrix.x_right.raw - 257;
  CHECK_OK(Style::make(matrix, kFilterText, style));
  CHECK_EQ(style.size().raw, 4 << 6);
  CHECK(style.is_stretched());
  CHECK(style.least_gain_q15() < 1 << 15);
}

TEST(the_upright_matrix_is_upright) {
  Style style;
  Style plain;
  for (int32_t px = 4; px <= 1024; ++px) {
    const double size = px;
    CHECK_OK(make({size, 0, 0, size}, style));
    CHECK_OK(Style::make(Q26_6::from_int(px), kFilterText, plain));
    CHECK(style.is_upright());
    CHECK_EQ(style.size().raw, plain.size().raw);
    CHECK_EQ(style.step_along_q16(), plain.step_along_q16());
  }
  CHECK_OK(make({-24, 0, 0, 24}, style));
  CHECK(!style.is_upright());
  CHECK(!style.is_stretched());
  CHECK_OK(make({24, 0, 0, 24.25}, style));
  CHECK(!style.is_upright());
  // Turned by 180 degrees, turned a very little, and a very little larger.
  constexpr int32_t kPx24 = 24 << 16;
  constexpr int32_t kNearly[][2] = {{-kPx24, 0}, {kPx24, 1}, {kPx24 + 1, 0}};
  for (const auto& near : kNearly) {
    const Matrix matrix = {Q16_16::from_raw(near[0]), Q16_16::from_raw(near[1]),
                           Q16_16::from_raw(-near[1]),
                           Q16_16::from_raw(near[0])};
    CHECK_OK(Style::make(matrix, kFilterText, style));
    CHECK_EQ(style.size().raw, 24 << 6);
    CHECK(!style.is_upright());
  }
}

// Steps and axes are each other's inverses, and the size is the greatest
// stretch.
TEST(steps_undo_the_matrix) {
  for (Rounds rounds(71, 2000); rounds.next();) {
    Random& random = rounds.random;
    const double most = random.between(4 * 64, 1024 * 64) / 64.0;
    const double least = 4 + (most - 4) * random.between(0, 1000) / 1000;
    const Map map = any_map(random, most, least);
    Style style;
    const Status status = make(map, style);
    if (least < 4.05 || most > 1023) {
      continue;  // roundings decide
    }
    CHECK_OK(status);
    CHECK(magnitude(style.size().raw / 64.0 - most) < 1.0 / 64);
    const double gain = style.least_gain_q15() / 32768.0;
    CHECK(most - least < most / 500 || magnitude(gain - least / most) < 0.004);
    const double x = random.between(-2000, 2000);
    const double y = random.between(-2000, 2000);
    const Map exact = map_of(matrix_of(map));
    const double right = (exact.x_right * x + exact.y_right * y) / 1024;
    const double up = (exact.x_up * x + exact.y_up * y) / 1024;
    const GlyphStep& to_right = style.right();
    const GlyphStep& to_up = style.up();
    const double px = 1024 * 64.0 / style.size().raw;
    const double x_px =
        (right * to_right.x_q20 + up * to_up.x_q20) / 1048576 * px;
    const double y_px =
        (right * to_right.y_q20 + up * to_up.y_q20) / 1048576 * px;
    CHECK(magnitude(x_px - x) < 0.01 * px && magnitude(y_px - y) < 0.01 * px);
    const double x_u = (right * to_right.x_q16 + up * to_up.x_q16) / 65536;
    const double y_u = (right * to_right.y_q16 + up * to_up.y_q16) / 65536;
    CHECK(magnitude(x_u - x) < 0.1 && magnitude(y_u - y) < 0.1);
  }
}
