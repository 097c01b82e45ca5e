// Points near each other: in any order they are what each is alone.
#include "distance/sampler.hpp"

#include "check.hpp"
#include "field_record.hpp"
#include "font_builder.hpp"
#include "inkcell/render.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using detail::CellSampler;
using detail::GlyphPoint;
using detail::ScreenGradient;
using detail::ScreenOffset;

constexpr int32_t kOne = 1 << 30;
constexpr int32_t kDirections[][2] = {
    {kOne, 0}, {0, kOne}, {759250125, 759250125}, {858993459, -644245094}};

alignas(4) uint8_t bytes[1536];
font_builder::Record samples;  // too large for the stack of a small board
#if INKCELL_EDGE_CELLS
FieldRecord record;
#endif

GlyphField field_of_samples(font_builder::Shape shape) {
  samples.reset();
  samples.fill(shape);
  GlyphField field;
  CHECK(samples.size() <= sizeof(bytes));
  samples.write(bytes);
  CHECK_OK(GlyphField::open({bytes, samples.size()}, field));
  return field;
}

#if INKCELL_EDGE_CELLS
GlyphField field_of_fields(Random& random) {
  record = FieldRecord();
  record.linked = (random.next() & 1) != 0;
  record.tiles_x = 2;
  record.tiles_y = 2;
  record.make(random, 128);
  GlyphField field;
  CHECK(record.size() <= sizeof(bytes));
  record.write(bytes);
  CHECK_OK(GlyphField::open({bytes, record.size()}, field));
  return field;
}
#endif

TextStyle style_of(int32_t size_q6, uint32_t turn) {
  Direction direction;
  direction.cosine.raw = kDirections[turn][0];
  direction.sine.raw = kDirections[turn][1];
  TextStyle style;
  CHECK_OK(
      TextStyle::make(Q26_6::from_raw(size_q6), kFilterText, direction, style));
  return style;
}

// A disc of samples is not quite round.
bool is_near(int32_t a_q14, double b_q14) {
  return a_q14 - b_q14 < 700 && b_q14 - a_q14 < 700;
}

int32_t clamped(int32_t distance_q10) {
  if (distance_q10 < INT16_MIN) {
    return INT16_MIN;
  }
  return distance_q10 > INT16_MAX ? INT16_MAX : distance_q10;
}

// Jumps about in a glyph, and steps. Returns the number of points that do not
// lie in saturated cells.
int check_points(const GlyphField& field,
                 const TextStyle& style,
                 Random& random) {
  const FinePoint origin(random.between(-999, 999), random.between(-999, 999));
  const Rect box = field_box(field, style, origin);
  CellSampler walk(field, style, detail::kNoReach);
  int edge = 0;
  for (int i = 0; i < 12; ++i) {
    const int32_t x = random.between(box.x0 - 2, box.x1 + 1);
    const int32_t y = random.between(box.y0 - 2, box.y1 + 1);
    const ScreenOffset offset = {random.between(-1500, 1500),
                                 random.between(-1500, 1500)};
    Q6_10 expected[5];
    distance_row(
        field, style,
        {origin.x_q10 - offset.right_q10, origin.y_q10 + offset.up_q10}, x, y,
        expected);
    GlyphPoint at = walk.point(origin, x, y, offset);
    for (const Q6_10& distance : expected) {
      CHECK_EQ(clamped(walk.distance_q10(at)), distance.raw);
      edge += walk.is_saturated() ? 0 : 1;
      at = detail::moved(at, detail::offset_of(style, {1 << 10, 0}));
    }
  }
  return edge;
}

}  // namespace

TEST(points_of_samples_are_what_each_is_alone) {
  int edge = 0;
  const font_builder::Shape shapes[] = {font_builder::disc, font_builder::ring,
                                        font_builder::bar};
  for (Rounds rounds(51, INKCELL_BOARD_FIRMWARE ? 12 : 300); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    const GlyphField field = field_of_samples(shapes[round % 3]);
    const TextStyle style =
        style_of(random.between(4 * 64, 200 * 64), random.below(4));
    edge += check_points(field, style, random);
  }
  CHECK(edge > 100);
}

// The gradient of a disc points to its middle, whichever way it is turned.
TEST(gradients_turn_with_the_glyph) {
  const GlyphField field = field_of_samples(font_builder::disc);
  for (uint32_t turn = 0; turn < 4; ++turn) {
    const TextStyle style = style_of(64 * 64, turn);
    // The middle, 24 px along both axes of the glyph.
    const double c = kDirections[turn][0] / double{kOne};
    const double s = kDirections[turn][1] / double{kOne};
    const double middle_x = 24 * c - 24 * s;
    const double middle_y = -24 * s - 24 * c;
    CellSampler walk(field, style, detail::kNoReach);
    const ScreenOffset offsets[] = {
        {18 * 1024, 0}, {0, -18 * 1024}, {-13 * 1024, 13 * 1024}};
    for (const ScreenOffset& from : offsets) {
      const auto x = static_cast<int32_t>(middle_x * 1024) + from.right_q10;
      const auto y = static_cast<int32_t>(middle_y * 1024) - from.up_q10;
      const ScreenGradient g =
          walk.gradient(walk.point({0, 0}, 0, 0, {x - 512, 512 - y}));
      const double away = from.right_q10 != 0 && from.up_q10 != 0
                              ? 13 * 1024 * 1.41421356
                              : 18 * 1024;
      CHECK(is_near(g.right_q14, -16384 * (from.right_q10 / away)));
      CHECK(is_near(g.up_q14, -16384 * (from.up_q10 / away)));
    }
  }
}

#if INKCELL_EDGE_CELLS

TEST(points_of_fields_are_what_each_is_alone) {
  int edge = 0;
  const int round_count = INKCELL_BOARD_FIRMWARE ? 30 : 1500;
  for (Rounds rounds(52, round_count); rounds.next();) {
    Random& random = rounds.random;
    const GlyphField field = field_of_fields(random);
    const TextStyle style =
        style_of(random.between(4 * 64, 200 * 64), random.below(4));
    edge += check_points(field, style, random);
  }
  CHECK(edge > round_count);
}

// Where a px is a u, gradients are those of gradient_at.
TEST(gradients_of_fields_are_those_of_the_glyph) {
  const TextStyle style = style_of(1024 * 64, 0);
  for (Rounds rounds(53, INKCELL_BOARD_FIRMWARE ? 10 : 300); rounds.next();) {
    Random& random = rounds.random;
    const GlyphField field = field_of_fields(random);
    CellSampler walk(field, style, detail::kNoReach);
    for (int i = 0; i < 20; ++i) {
      const int32_t x = random.between(-10, 520);
      const int32_t y = random.between(-520, 10);
      const ScreenGradient found = walk.gradient(walk.point({0, 0}, x, y));
      const Gradient expected =
          gradient_at(field, Q16_16::from_raw(x * 65536 + 32768),
                      Q16_16::from_raw(-y * 65536 - 32768));
      CHECK_EQ(found.right_q14, expected.x.raw);
      CHECK_EQ(found.up_q14, expected.y.raw);
    }
  }
}

#endif  // INKCELL_EDGE_CELLS
