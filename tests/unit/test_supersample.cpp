// Several samples to a pixel: what they are, where they matter, and that no
// picture depends on how it is cut.
#include "inkcell/supersample.hpp"

#include "check.hpp"
#include "effect_canvas.hpp"
#include "field_record.hpp"
#include "font_builder.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using effect::Canvas;
using effect::check_windows;
using effect::draw;
using effect::ink;
using effect::kAll;
using effect::keep;
using effect::kSide;
using effect::magnitude;
using effect::picture;
using effect::whole;

constexpr int32_t kOne = 1 << 30;
constexpr int32_t kDirections[][2] = {
    {kOne, 0}, {759250125, 759250125}, {858993459, -644245094}};

alignas(4) uint8_t bytes[1536];
font_builder::Record samples;  // too large for the stack of a small board
FieldRecord record;

template <typename Source>
GlyphField open(const Source& source) {
  GlyphField field;
  CHECK(source.size() <= sizeof(bytes));
  source.write(bytes);
  CHECK_OK(GlyphField::open({bytes, source.size()}, field));
  return field;
}

GlyphField field_of_samples(font_builder::Shape shape) {
  samples.reset();
  samples.fill(shape);
  return open(samples);
}

TextStyle style_of(int32_t size_q6,
                   uint32_t turn,
                   const Supersampling& supersampling) {
  Direction direction;
  direction.cosine.raw = kDirections[turn][0];
  direction.sine.raw = kDirections[turn][1];
  TextStyle style;
  CHECK_OK(
      TextStyle::make(Q26_6::from_raw(size_q6), kFilterText, direction, style));
  style.set_effect(supersample_effect(supersampling));
  return style;
}

// The mean coverage of 13 distances, each asked for alone.
int32_t mean_of_13(const GlyphField& field,
                   const TextStyle& style,
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
                const TextStyle& style,
                FinePoint origin,
                double radius,
                int32_t tolerance) {
  draw(field, style, origin);
  int differ = 0;
  for (int32_t y = kAll.y0; y < kAll.y1; y += 3) {
    for (int32_t x = kAll.x0; x < kAll.x1; ++x) {
      const int32_t found = picture[(y - kAll.y0) * kSide + x - kAll.x0];
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

#if INKCELL_EDGE_CELLS

// Where a field is a plane one sample says what 13 do, whatever its direction.
TEST(straight_edges_take_one_sample) {
  uint32_t more = 0;
  Supersampling supersampling = make_supersampling(kFilterText);
  supersampling.more_samples = &more;
  for (Rounds rounds(61, INKCELL_BOARD_FIRMWARE ? 3 : 40); rounds.next();) {
    Random& random = rounds.random;
    record = FieldRecord();
    record.tile_log2 = 11;
    record.x0_u = -1000;
    record.y0_u = -1000;
    record.line_count = 1;
    record.fields[0] = random_field(random, 0, 0, 100);
    record.references[0] = record.field_reference(0);
    const GlyphField field = open(record);
    const TextStyle style = style_of(40 * 64, random.below(3), supersampling);
    const FinePoint origin(16 * 1024 + random.between(0, 1023),
                           16 * 1024 + random.between(0, 1023));
    check_means(field, style, origin, 870 / 1024.0, 5);
  }
  CHECK_EQ(more, 0u);
}

#endif  // INKCELL_EDGE_CELLS

TEST(small_shapes_take_thirteen) {
  const Supersampling supersampling = make_supersampling(kFilterText);
  int differ = 0;
  const font_builder::Shape shapes[] = {font_builder::disc, font_builder::ring,
                                        font_builder::bar};
  for (Rounds rounds(62, INKCELL_BOARD_FIRMWARE ? 3 : 60); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    const GlyphField field = field_of_samples(shapes[round % 3]);
    const TextStyle style = style_of(random.between(4 * 64, 24 * 64),
                                     random.below(3), supersampling);
    const FinePoint origin(8 * 1024 + random.between(0, 1023),
                           24 * 1024 + random.between(0, 1023));
    differ += check_means(field, style, origin, 870 / 1024.0, 12);
  }
  CHECK(differ > 3);
}

TEST(windows_do_not_change_pictures) {
  const Supersampling styles[] = {
      make_supersampling(kFilterText),
      make_supersampling(kFilterText, kPaperRadius, SampleRule::paper)};
  for (Rounds rounds(63, INKCELL_BOARD_FIRMWARE ? 4 : 24); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    const TextStyle style = style_of(random.between(8 * 64, 40 * 64),
                                     random.below(3), styles[round & 1]);
    const FinePoint origin(random.between(0, 9999),
                           random.between(9999, 30000));
    check_windows(field_of_samples(font_builder::ring), style, origin);
#if INKCELL_EDGE_CELLS
    record = FieldRecord();
    record.tiles_x = 2;
    record.tiles_y = 2;
    record.make(random, 128);
    check_windows(open(record), style, origin);
#endif
  }
}

#if INKCELL_EDGE_CELLS

// A bar 0.9 px wide has the same ink wherever it stands, and no pixel jumps.
TEST(moving_bars_keep_their_ink) {
  const Supersampling supersampling = make_supersampling(kFilterText);
  record = FieldRecord();
  record.tile_log2 = 11;
  record.x0_u = -1000;
  record.y0_u = -1000;
  record.line_count = 2;
  record.pair_count = 1;
  record.fields[0] = {16384, 0, 230, 0, 0};
  record.fields[1] = {-16384, 0, 230, 0, 0};
  record.pairs[0][1] = 1;
  record.references[0] = record.pair_reference(0);
  const GlyphField field = open(record);
  for (uint32_t turn = 0; turn < 3; ++turn) {
    const TextStyle style = style_of(32 * 64, turn, supersampling);
    int32_t least = INT32_MAX;
    int32_t most = 0;
    int32_t jump = 0;
    for (int32_t i = 0; i <= 64; ++i) {
      draw(field, style, {16384 + 16 * i, 16384 + 7 * i});
      least = ink() < least ? ink() : least;
      most = ink() > most ? ink() : most;
      for (int32_t j = 0; i != 0 && j < kSide * kSide; ++j) {
        const int32_t change = magnitude(picture[j] - whole[j]);
        jump = change > jump ? change : jump;
      }
      keep();
    }
    CHECK(jump <= 6);
    // On a diagonal the window's corners cut more or less off.
    CHECK(most - least <= (turn == 1 ? most / 16 : most / 25));
  }
}

// 13 samples on small cells, five and one on larger ones, as the paper says.
TEST(cells_decide_by_the_papers_rule) {
  uint32_t more = 0;
  Supersampling supersampling =
      make_supersampling(kFilterText, kPaperRadius, SampleRule::paper);
  supersampling.more_samples = &more;
  // Cells of 64 u: 4, 1 and 0.5 px.
  const int32_t sizes[] = {64 * 64, 16 * 64, 8 * 64};
  record = FieldRecord();
  record.tile_log2 = 6;
  record.line_count = 1;
  record.fields[0] = {16384, 0, -16 * 32, 0, 0};
  record.references[0] = record.field_reference(0);
  const GlyphField field = open(record);
  const uint32_t expected[] = {0, 4, 12};
  for (int i = 0; i < 3; ++i) {
    const TextStyle style = style_of(sizes[i], 0, supersampling);
    more = 0;
    // The pixel whose centre is on the edge, in the middle of the cell.
    const int32_t middle = (512 * sizes[i]) >> 10;  // 32 u in px, Q10
    Canvas canvas({0, 0, 1, 1});
    draw_field(field, style, {512 - middle, 512 + middle}, canvas.sink());
    CHECK_EQ(more, expected[i]);
  }
}

#endif  // INKCELL_EDGE_CELLS

// 48/64 of a cell's width to the right and 16/64 up: no sample more is taken.
TEST(planes_of_samples_take_one_sample) {
  uint32_t more = 0;
  Supersampling supersampling = make_supersampling(kFilterText);
  supersampling.more_samples = &more;
  samples.reset();
  samples.tile_log2 = 10;
  samples.tiles_x = samples.tiles_y = 1;
  samples.x0_u = samples.y0_u = 0;
  samples.reference_count = 1;
  constexpr int8_t kPlane[8] = {-64, -16, 32, -48, 48, -32, 16, 64};
  samples.references[0] = samples.add_raw_cell(0, kPlane);
  const GlyphField field = open(samples);
  const TextStyle style = style_of(20 * 64, 0, supersampling);
  Canvas canvas({0, 0, 1, 1});
  draw_field(field, style, {512 - 10 * 1024, 512 + 10 * 1024}, canvas.sink());
  CHECK_EQ(more, 0);
}

TEST(radii_are_clamped) {
  constexpr int16_t kLeast = 256;
  constexpr int16_t kMost = 1536;
  const int16_t radii[][2] = {{kLeast, kLeast},     {kMost, kMost},
                              {kLeast - 1, kLeast}, {kMost + 1, kMost},
                              {INT16_MIN, kLeast},  {INT16_MAX, kMost}};
  for (const auto& radius : radii) {
    CHECK_EQ(
        make_supersampling(kFilterText, Q6_10::from_raw(radius[0])).radius_q10,
        radius[1]);
  }
}
