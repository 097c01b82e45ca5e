// Styles of any matrix: which are allowed, and what their steps are.
#include "check.hpp"
#include "inkcell/style.hpp"
#include "place/style_parts.hpp"
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

Style style_of(const Map& map) {
  return Style(matrix_of(map), kFilterText);
}

bool is_in_range(const Map& map) {
  return stretch_of(matrix_of(map)).is_in_range();
}

bool is_near(double found, double wanted) {
  return magnitude(found - wanted) < 0.01 * magnitude(wanted) + 0.001;
}

// Whether a style maps as `map` does, in px.
bool maps_as(const Style& style, const Map& map) {
  const double px = style.size().raw / 64.0 / (1 << 30);
  const Style::Axes& axes = style.axes();
  return is_near(axes.x_right.raw * px, map.x_right) &&
         is_near(axes.y_right.raw * px, map.y_right) &&
         is_near(axes.x_up.raw * px, map.x_up) &&
         is_near(axes.y_up.raw * px, map.y_up);
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

TEST(stretches_of_matrices) {
  CHECK(!is_in_range({0, 0, 0, 0}));
  CHECK(!is_in_range({24, 24, 24, 24}));
  CHECK(!is_in_range({3.9, 0, 0, 24}));
  CHECK(!is_in_range({24, 0, 0, 1025}));
  CHECK(!is_in_range({800, 800, -800, 800}));
  CHECK(!is_in_range({24, 1000, 0, 24}));
  CHECK(is_in_range({4, 0, 0, 1024}));
  CHECK(is_in_range({0, -4, 4, 0}));
  CHECK(is_in_range({-1024, 0, 0, 4}));
  const int32_t ends[] = {INT32_MIN, INT32_MAX};
  for (const int32_t a : ends) {
    for (const int32_t b : ends) {
      const Matrix far = {Q16_16::from_raw(a), Q16_16::from_raw(b),
                          Q16_16::from_raw(b), Q16_16::from_raw(a)};
      const Stretch stretch = stretch_of(far);
      CHECK(!stretch.is_in_range());
      CHECK_EQ((stretch.greatest.raw + (1 << 15)) >> 16, 64);
      CHECK(stretch.least.raw < 64);
    }
  }
}

TEST(matrices_in_range_are_kept) {
  const Style tall = style_of({4, 0, 0, 1024});
  CHECK_EQ(tall.size().raw, 1024 << 6);
  CHECK_EQ(detail::StyleParts::least_gain_q15(tall), 1 << 7);
  CHECK(!style_of({0, -4, 4, 0}).is_stretched());
  CHECK(maps_as(style_of({-1024, 0, 0, 4}), {-1024, 0, 0, 4}));
  const Style leaning = style_of({20, 8, 0, 20});
  CHECK(leaning.is_stretched());
  CHECK(!leaning.is_upright());
}

TEST(other_matrices_are_scaled) {
  // As large as it may be, as small, and to where the lesser is large enough.
  CHECK(maps_as(style_of({0, -2048, 1024, 0}), {0, -1024, 512, 0}));
  CHECK(maps_as(style_of({32767, 0, 0, 32767}), {1024, 0, 0, 1024}));
  CHECK(maps_as(style_of({-0.5, 0, 0, 0.5}), {-4, 0, 0, 4}));
  CHECK(maps_as(style_of({2, 0, 0, 24}), {4, 0, 0, 48}));
  CHECK(maps_as(style_of({2, 0, 0, -400}), {4, 0, 0, -800}));
}

TEST(flat_matrices_are_upright) {
  const Map flat[] = {
      {0, 0, 0, 0}, {24, 24, 24, 24}, {0, 0, 0, -24}, {3, 0, 0, 1000}};
  const int32_t sizes[] = {4, 48, 24, 1000};
  for (int i = 0; i < 4; ++i) {
    const Style style = style_of(flat[i]);
    CHECK(style.is_upright());
    CHECK_EQ(style.size().raw, sizes[i] << 6);
  }
}

// Whatever a matrix is, its style has numbers that drawing can bear.
TEST(any_matrix_makes_a_style) {
  for (Random& random : Rounds(72, 20000)) {
    Q16_16 entries[4];
    for (Q16_16& entry : entries) {
      entry.raw = static_cast<int32_t>(random.next()) >> random.below(32);
    }
    const Matrix matrix = {entries[0], entries[1], entries[2], entries[3]};
    const Style style(matrix, kFilterText);
    CHECK(style.size().raw >= kMinSize.raw);
    CHECK(style.size().raw <= kMaxSize.raw);
    const int32_t gain = detail::StyleParts::least_gain_q15(style);
    CHECK(gain >= 127 && gain <= 1 << 15);
    const int64_t steps[] = {style.right().x_q20, style.right().y_q20,
                             style.up().x_q20, style.up().y_q20};
    for (const int64_t step : steps) {
      CHECK(step <= 257 << 20 && step >= -(257 << 20));
    }
  }
}

// Entries whose squares would wrap to those of a size of about 24 px.
TEST(huge_matrices_do_not_pass_for_small_ones) {
  constexpr int32_t kPx24 = 24 << 16;
  for (const int32_t far : each_of({INT32_MIN, INT32_MAX})) {
    const Matrix matrix = {Q16_16::from_raw(far), Q16_16::from_raw(kPx24),
                           Q16_16::from_raw(-kPx24), Q16_16::from_raw(far)};
    CHECK(!stretch_of(matrix).is_in_range());
    CHECK_EQ(Style(matrix, kFilterText).size().raw, kMaxSize.raw);
  }
}

TEST(stretches_are_rounded_to_1_64_px) {
  const auto is_raw_in_range = [](int32_t most_q16, int32_t least_q16) {
    return stretch_of({Q16_16::from_raw(most_q16),
                       {},
                       {},
                       Q16_16::from_raw(least_q16)})
        .is_in_range();
  };
  CHECK(is_raw_in_range((1024 << 16) + 511, (4 << 16) - 512));
  CHECK(!is_raw_in_range((1024 << 16) + 512, 4 << 16));
  CHECK(!is_raw_in_range(1024 << 16, (4 << 16) - 513));
}

TEST(stretches_within_1_1024_are_alike) {
  constexpr int32_t kMost = 64 << 16;
  constexpr int32_t kPart = kMost / 1024;
  Matrix matrix;
  matrix.x_right.raw = kMost;
  matrix.y_up.raw = kMost - kPart;
  Style style(matrix, kFilterText);
  CHECK(!style.is_upright() && !style.is_stretched());
  matrix.y_up.raw = kMost - kPart - 1;
  style = Style(matrix, kFilterText);
  CHECK(style.is_stretched());
  // Where the size is rounded down the least stretch may be greater.
  matrix.x_right.raw = (4 << 16) + 511;
  matrix.y_up.raw = matrix.x_right.raw - 257;
  style = Style(matrix, kFilterText);
  CHECK_EQ(style.size().raw, 4 << 6);
  CHECK(style.is_stretched());
  CHECK(detail::StyleParts::least_gain_q15(style) < 1 << 15);
}

TEST(the_upright_matrix_is_upright) {
  for (int32_t px = 4; px <= 1024; ++px) {
    const double size = px;
    CHECK(is_same(style_of({size, 0, 0, size}),
                  Style(Q26_6::from_int(px), kFilterText)));
  }
  const Style mirrored = style_of({-24, 0, 0, 24});
  CHECK(!mirrored.is_upright());
  CHECK(!mirrored.is_stretched());
  CHECK(!style_of({24, 0, 0, 24.25}).is_upright());
  // Turned by 180 degrees, turned a very little, and a very little larger.
  constexpr int32_t kPx24 = 24 << 16;
  constexpr int32_t kNearly[][2] = {{-kPx24, 0}, {kPx24, 1}, {kPx24 + 1, 0}};
  for (const auto& near : kNearly) {
    const Matrix matrix = {Q16_16::from_raw(near[0]), Q16_16::from_raw(near[1]),
                           Q16_16::from_raw(-near[1]),
                           Q16_16::from_raw(near[0])};
    const Style style(matrix, kFilterText);
    CHECK_EQ(style.size().raw, 24 << 6);
    CHECK(!style.is_upright());
  }
}

// Steps and axes are each other's inverses, and the size is the greatest
// stretch.
TEST(steps_undo_the_matrix) {
  for (Random& random : Rounds(71, 2000)) {
    const double most = random.between(4 * 64, 1024 * 64) / 64.0;
    const double least = 4 + (most - 4) * random.between(0, 1000) / 1000;
    const Map map = any_map(random, most, least);
    if (least < 4.05 || most > 1023) {
      continue;  // roundings decide
    }
    const Style style = style_of(map);
    CHECK(is_in_range(map));
    CHECK(magnitude(style.size().raw / 64.0 - most) < 1.0 / 64);
    const double gain = detail::StyleParts::least_gain_q15(style) / 32768.0;
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
