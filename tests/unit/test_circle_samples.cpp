// Several samples to a pixel: what they are, where they matter, and that no
// picture depends on how it is cut.
#include "inkcell/field/circle_samples.hpp"

#include "check.hpp"
#include "effect_canvas.hpp"
#include "effect_glyph.hpp"
#include "font_builder.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using namespace effect;

constexpr int32_t kOne = 1 << 30;
constexpr int32_t kDirections[][2] = {
    {kOne, 0}, {759250125, 759250125}, {858993459, -644245094}};

Style style_of(int32_t size_q6, uint32_t turn, const CircleSamples& options) {
  Direction direction;
  direction.cosine.raw = kDirections[turn][0];
  direction.sine.raw = kDirections[turn][1];
  Style style(Q26_6::from_raw(size_q6), kFilterText, direction);
  style.set_effect(options);
  return style;
}

// The mean coverage of 13 distances, each asked for alone.
int32_t mean_of_13(const GlyphField& field,
                   const Style& style,
                   FinePoint origin,
                   int32_t x,
                   int32_t y,
                   double radius) {
  const double root = 0.70710678;
  const double inner = radius / 3 * root;
  const double outer = radius * 2 / 3;
  const double places[13][3] = {{0, 0, 1},
                                {inner, inner, 0.79370},
                                {inner, -inner, 0.79370},
                                {-inner, inner, 0.79370},
                                {-inner, -inner, 0.79370},
                                {outer, 0, 0.39685},
                                {-outer, 0, 0.39685},
                                {0, outer, 0.39685},
                                {0, -outer, 0.39685},
                                {outer * root, outer * root, 0.39685},
                                {outer * root, -outer * root, 0.39685},
                                {-outer * root, outer * root, 0.39685},
                                {-outer * root, -outer * root, 0.39685}};
  double sum = 0;
  double weights = 0;
  for (const auto& place : places) {
    Q6_10 distance;
    distance_row(field, style,
                 {origin.x_q10 - static_cast<int64_t>(place[0] * 1024),
                  origin.y_q10 - static_cast<int64_t>(place[1] * 1024)},
                 x, y, {&distance, 1});
    sum += place[2] * style.filter().coverage(distance.raw);
    weights += place[2];
  }
  return static_cast<int32_t>(sum / weights + 0.5);
}

// Every pixel of a random glyph against the mean of 13. Returns the number of
// pixels that one sample would have shown differently.
int check_means(const GlyphField& field,
                const Style& style,
                FinePoint origin,
                double radius,
                int32_t tolerance) {
  draw(field, style, origin);
  int differ = 0;
  for (int32_t y = kAll.y0; y < kAll.y1; y += 3) {
    for (int32_t x = kAll.x0; x < kAll.x1; ++x) {
      const int32_t found = picture.at(x, y);
      const int32_t expected = mean_of_13(field, style, origin, x, y, radius);
      CHECK(magnitude(found - expected) <= tolerance);
      Q6_10 distance;
      distance_row(field, style, origin, x, y, {&distance, 1});
      const int32_t one = style.filter().coverage(distance.raw);
      differ += magnitude(one - expected) > 12 ? 1 : 0;
    }
  }
  return differ;
}

}  // namespace

// A cell around the origin, where a straight edge passes; of slope 1.
GlyphField plane(uint8_t tile_log2) {
  glyph_record.reset();
  glyph_record.tile_log2 = tile_log2;
  glyph_record.tiles_x = glyph_record.tiles_y = 1;
  glyph_record.x0_u = glyph_record.y0_u =
      static_cast<int16_t>(-(1 << tile_log2) / 2);
  glyph_record.reference_count = 1;
  constexpr int8_t kPlane[8] = {-89, -51, -13, -38, 38, 13, 51, 89};
  glyph_record.references[0] = glyph_record.add_raw_cell(0, kPlane);
  return open_glyph();
}

// Where a field is a plane one sample says what 13 do, whatever its direction.
TEST(straight_edges_take_five_samples) {
  uint32_t more = 0;
  CircleSamples options(kFilterText);
  options.more_samples = &more;
  const GlyphField field = plane(11);
  for (Random& random : Rounds(61, INKCELL_BOARD_FIRMWARE ? 3 : 40)) {
    const Style style = style_of(40 * 64, random.below(3), options);
    const FinePoint origin(16 * 1024 + random.between(0, 1023),
                           16 * 1024 + random.between(0, 1023));
    more = 0;
    check_means(field, style, origin, 870 / 1024.0, 5);
    CHECK(more > 0 && more % 4 == 0 && more < 4 * 4 * kSide);
  }
}

TEST(small_shapes_take_thirteen) {
  const CircleSamples options(kFilterText);
  int differ = 0;
  const font_builder::Shape shapes[] = {font_builder::disc, font_builder::ring,
                                        font_builder::bar};
  Rounds rounds(62, INKCELL_BOARD_FIRMWARE ? 3 : 60);
  for (Random& random : rounds) {
    const GlyphField field = field_of(shapes[rounds.number % 3]);
    const Style style =
        style_of(random.between(4 * 64, 24 * 64), random.below(3), options);
    const FinePoint origin(8 * 1024 + random.between(0, 1023),
                           24 * 1024 + random.between(0, 1023));
    differ += check_means(field, style, origin, 870 / 1024.0, 12);
  }
  CHECK(differ > 3);
}

TEST(windows_do_not_change_pictures) {
  const CircleSamples styles[] = {
      CircleSamples(kFilterText),
      CircleSamples(kFilterText, kPaperRadius, SampleRule::paper)};
  Rounds rounds(63, INKCELL_BOARD_FIRMWARE ? 4 : 24);
  for (Random& random : rounds) {
    const Style style = style_of(random.between(8 * 64, 40 * 64),
                                 random.below(3), styles[rounds.number & 1]);
    const FinePoint origin(random.between(0, 9999),
                           random.between(9999, 30000));
    check_windows(field_of(font_builder::ring), style, origin);
  }
}

// 13 samples on small cells, five and one on larger ones, as the paper says.
TEST(cells_decide_by_the_papers_rule) {
  uint32_t more = 0;
  CircleSamples options(kFilterText, kPaperRadius, SampleRule::paper);
  options.more_samples = &more;
  // Cells of 64 u: 4, 1 and 0.5 px.
  const int32_t sizes[] = {64 * 64, 16 * 64, 8 * 64};
  const GlyphField field = plane(6);
  const uint32_t expected[] = {0, 4, 12};
  for (int i = 0; i < 3; ++i) {
    const Style style = style_of(sizes[i], 0, options);
    more = 0;
    Picture<1, 1> pixel;
    draw_field(field, style, {512, 512}, pixel.sink());
    CHECK_EQ(more, expected[i]);
  }
}

TEST(radii_are_clamped) {
  constexpr int16_t kLeast = 256;
  constexpr int16_t kMost = 1536;
  const int16_t radii[][2] = {{kLeast, kLeast},     {kMost, kMost},
                              {kLeast - 1, kLeast}, {kMost + 1, kMost},
                              {INT16_MIN, kLeast},  {INT16_MAX, kMost}};
  for (const auto& radius : radii) {
    CHECK_EQ(CircleSamples(kFilterText, Q6_10::from_raw(radius[0])).radius_q10,
             radius[1]);
  }
}
