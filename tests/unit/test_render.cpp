// The renderer: what it may touch, in which order, and that every way to draw
// a picture gives the same one.
#include "inkcell/field/draw.hpp"

#include "any_record.hpp"
#include "check.hpp"
#include "effect_glyph.hpp"
#include "font_builder.hpp"
#include "picture.hpp"
#include "pixels.hpp"
#include "random.hpp"
#include "rounds.hpp"
#include "sink_calls.hpp"

namespace {

using namespace inkcell;
using effect::field_of;
using effect::open_glyph;
using font_builder::Record;

constexpr int32_t kSide = 40;

// Too large for the stack of a small board.
Picture<kSide, kSide> canvas;
Picture<kSide, kSide> reference;
Record& record = effect::glyph_record;

Direction direction(int32_t cosine_q30, int32_t sine_q30) {
  Direction result;
  result.cosine.raw = cosine_q30;
  result.sine.raw = sine_q30;
  return result;
}

constexpr int32_t kOne = 1 << 30;
constexpr int32_t kHalfRoot = 759250125;  // cosine of 45 degrees

// Quarter turns, 45 degrees, the 3-4-5 triangle, and nearly upright.
constexpr int32_t kDirections[][2] = {{kOne, 0},
                                      {0, kOne},
                                      {-kOne, 0},
                                      {0, -kOne},
                                      {kHalfRoot, kHalfRoot},
                                      {-kHalfRoot, kHalfRoot},
                                      {858993459, -644245094},
                                      {kOne, 1}};

Style style_of(int32_t size_q6, const int32_t (&turn)[2] = kDirections[0]) {
  return Style(Q26_6::from_raw(size_q6), kFilterText,
               direction(turn[0], turn[1]));
}

// A window of at most kSide pixels a side somewhere in or around the box.
Rect window_in(Random& random, const Rect& box) {
  const int32_t x0 = random.between(box.x0 - 3, box.x1 + 2);
  const int32_t y0 = random.between(box.y0 - 3, box.y1 + 2);
  return {x0, y0, x0 + random.between(1, kSide), y0 + random.between(1, kSide)};
}

// What bands round, 1/254 px, and the roundings of 16 steps from sample to
// sample; those are larger above the sizes of fonts.
int32_t tolerance_of(const Style& style) {
  return style.size().raw <= 64 * 64 ? 3 : 8;
}

// An empty picture whose first pixel is that of `window`; the sink for it.
Sink clear(Picture<kSide, kSide>& picture, const Rect& window) {
  picture.clear_at(window.x0, window.y0);
  return picture.sink(window);
}

// draw_field against distances one by one and the filter.
void check_plain_chain(const GlyphField& field,
                       const Style& style,
                       const FinePoint& origin,
                       const Rect& window) {
  draw_field(field, style, origin, clear(canvas, window));
  for (int32_t y = window.y0; y < window.y1; ++y) {
    Q6_10 distances[kSide];
    const auto width = static_cast<size_t>(window.x1 - window.x0);
    distance_row(field, style, origin, window.x0, y, {distances, width});
    for (int32_t x = window.x0; x < window.x1; ++x) {
      const int32_t distance = distances[x - window.x0].raw;
      const int32_t error = canvas.at(x, y) - style.filter().coverage(distance);
      CHECK(error <= tolerance_of(style) && -error <= tolerance_of(style));
    }
  }
}

}  // namespace

TEST(fused_drawing_equals_the_plain_chain) {
  const GlyphField field = field_of(font_builder::ring);
  Random random(1);
  const int32_t sizes[] = {4 * 64,   4 * 64 + 1,  7 * 64 + 5,    12 * 64,  1000,
                           24 * 64,  48 * 64 - 1, 48 * 64,       64 * 64,  6000,
                           200 * 64, 40000,       1024 * 64 - 1, 1024 * 64};
  for (const int32_t size : sizes) {
    for (const auto& turn : kDirections) {
      const Style style = style_of(size, turn);
      for (int i = 0; i < 6 && !check::failed(); ++i) {
        const FinePoint origin(random.between(-50000, 50000),
                               random.between(-50000, 50000));
        const Rect box = field_box(field, style, origin);
        check_plain_chain(field, style, origin, window_in(random, box));
      }
    }
  }
}

// Numbers without sense make a picture without sense, but only one.
TEST(windows_do_not_change_any_cells) {
  Rounds rounds(2, 120);
  for (Random& random : rounds) {
    make_any(record, random);
    const GlyphField field = open_glyph();
    // Every other time pixels lie on the borders of cells exactly.
    const bool exact = rounds.number % 2 != 0;
    const int32_t size =
        exact ? 256 << random.below(9) : random.between(4 * 64, 600 * 64);
    const Style style = style_of(
        size, kDirections[rounds.number % 4 < 2 ? 0 : random.below(8)]);
    const FinePoint origin(exact ? 512 + 1024 * random.between(-9, 9)
                                 : random.between(-9999, 9999),
                           exact ? 512 : random.between(-9999, 9999));
    const Rect box = field_box(field, style, origin);
    for (int i = 0; i < 4; ++i) {
      const Rect window = window_in(random, box);
      const int32_t x = random.between(window.x0, window.x1);
      const int32_t y = random.between(window.y0, window.y1);
      draw_field(field, style, origin, clear(reference, window));
      canvas.clear_at(window.x0, window.y0);
      for (int part = 0; part < 4; ++part) {
        const Rect quarter = {
            part % 2 == 0 ? window.x0 : x, part / 2 == 0 ? window.y0 : y,
            part % 2 == 0 ? x : window.x1, part / 2 == 0 ? y : window.y1};
        draw_field(field, style, origin, canvas.sink(quarter));
      }
      CHECK(canvas == reference);
    }
  }
}

namespace {

// Rows 1 to all, and every split into a left and a right part.
void check_strips(int32_t size) {
  const GlyphField field = field_of(font_builder::ring);
  const Rect all = {-3, -2, -3 + kSide, -2 + kSide};
  for (const auto& turn : kDirections) {
    const Style style = style_of(size, turn);
    const FinePoint origin(turn[0] > 0 ? 123 : 30123,
                           turn[1] < 0 ? 4567 : 28765);
    draw_field(field, style, origin, clear(reference, all));
    CHECK(reference.ink() > 0);
    const auto draw = [&](const Sink& sink) {
      draw_field(field, style, origin, sink);
    };
    for (int32_t rows = 1; rows < kSide; ++rows) {
      canvas.clear_at(all.x0, all.y0);
      canvas.draw_strips(rows, draw);
      CHECK(canvas == reference);
    }
    for (int32_t column = 0; column <= kSide; ++column) {
      canvas.clear();
      canvas.draw_parts(kSide, column, draw);
      CHECK(canvas == reference);
    }
  }
}

}  // namespace

TEST(strips_do_not_change_the_picture) {
  check_strips(37 * 64 + 11);  // samples row by row where upright
  check_strips(53 * 64 + 5);   // and cell by cell
}

namespace {

// The sum of coverage of all that is drawn, by place.
struct PlacedSum : SinkCalls<PlacedSum> {
  uint32_t sum = 0;

  void put(int32_t x, int32_t y, const uint8_t* values, int32_t count) {
    for (int32_t i = 0; i < count; ++i) {
      const uint32_t value = values == nullptr ? 255 : values[i];
      sum += value * static_cast<uint32_t>(7 * (x + i) + y);
    }
  }
};
uint32_t sum_in(const GlyphField& field,
                const Style& style,
                const Rect& window) {
  PlacedSum sum;
  draw_field(field, style, {},
             {window, &sum, PlacedSum::coverage, PlacedSum::solid});
  return sum.sum;
}

// A column of 90 saturated tiles at the end of what grids may reach.
GlyphField far_column() {
  constexpr uint32_t kTiles = 90;
  constexpr int32_t kLeft = 15104;
  constexpr int32_t kLow = -7680;
  static uint8_t column[12 + 2 * kTiles] = {1, 8};
  font_builder::put_u16(column + 2, kLeft);
  font_builder::put_u16(column + 4, static_cast<uint16_t>(kLow));
  column[6] = 1;
  column[7] = kTiles;
  for (uint32_t i = 0; i < kTiles; ++i) {
    font_builder::put_u16(column + 12 + 2 * i, format::glyph::kInside);
  }
  GlyphField field;
  CHECK_OK(GlyphField::open({column, sizeof(column)}, field));
  return field;
}

}  // namespace

// A row may be a whole grid away from the glyph where it begins, and more.
TEST(rows_may_begin_far_from_the_grid) {
  const GlyphField field = far_column();
  for (int32_t lean = -240; lean <= 240; lean += 24) {
    Style style({Q16_16::from_int(30), Q16_16::from_int(0),
                 Q16_16::from_int(lean), Q16_16::from_int(60)},
                kFilterText);
    const int32_t x = 15232 * 30 / 1024;
    const Rect all = {x - 47000 * 30 / 1024, -20, x + 400, 20};
    const uint32_t whole = sum_in(field, style, all);
    CHECK(whole != 0);
    uint32_t parts = 0;
    for (int32_t x0 = all.x0; x0 < all.x1; x0 += 60) {
      parts +=
          sum_in(field, style, intersect(all, {x0, all.y0, x0 + 60, all.y1}));
    }
    CHECK_EQ(parts, whole);
  }
}

// Turned by quarters about a pixel corner the same points are sampled.
TEST(quarter_turns_turn_the_picture) {
  const GlyphField field = field_of(font_builder::bar);
  const Rect around = {-20, -20, 20, 20};
  // exact steps
  for (const int32_t size : each_of({8 * 64, 16 * 64, 32 * 64})) {
    draw_field(field, style_of(size), {}, clear(reference, around));
    CHECK(reference.ink() > 0);
    for (int quarter = 1; quarter < 4; ++quarter) {
      draw_field(field, style_of(size, kDirections[quarter]), {},
                 clear(canvas, around));
      for (const auto [x, y] : pixels_of({-20, -20, 20, 20})) {
        const int32_t from_x[] = {x, -1 - y, -1 - x, y};
        const int32_t from_y[] = {y, x, -1 - y, -1 - x};
        CHECK_EQ(canvas.at(x, y),
                 reference.at(from_x[quarter], from_y[quarter]));
      }
    }
  }
}

// The left side of a bar, half as high as it is wide, leaning and mirrored: the
// same distance on the screen.
TEST(stretched_edges_are_as_sharp) {
  const GlyphField field = field_of(font_builder::bar);
  // A place (x, y) in em goes to 96 x + lean y, 48 y: the side leans, and is so
  // long for each em.
  constexpr struct {
    int32_t lean;
    double length;
  } kSides[] = {{0, 48}, {24, 53.665631}, {-60, 76.837491}};
  for (const auto& side : kSides) {
    const int32_t lean = side.lean;
    const Matrix matrix = {
        Q16_16::from_int(96), {}, Q16_16::from_int(lean), Q16_16::from_int(48)};
    Style style(matrix, kFilterText);
    const FinePoint origin(3000, 40000);
    for (int32_t y = 25; y < 35; ++y) {
      Q6_10 distances[40];
      distance_row(field, style, origin, 0, y, {distances, 40});
      for (int32_t x = 0; x < 40; ++x) {
        const double up = 40000 / 1024.0 - y - 0.5;
        const double right = x + 0.5 - 3000 / 1024.0;
        const double across = right - up * lean / 48 - 96 * 200 / 1024.0;
        const double expected = across * 48 / side.length;
        if (expected > -1 && expected < 1) {
          const double error = distances[x].raw / 1024.0 - expected;
          CHECK(error < 0.02 && error > -0.02);
        }
      }
    }
    check_plain_chain(field, style, origin, {0, 10, 40, 45});
  }
}

// A disc stays a disc, turned about the origin.
TEST(turned_shapes_are_where_they_should_be) {
  const GlyphField field = field_of(font_builder::disc);
  const double size = 30;
  for (const auto& turn : kDirections) {
    draw_field(field, style_of(30 * 64, turn), {},
               clear(canvas, {-20, -20, 20, 20}));
    const double cosine = turn[0] / static_cast<double>(kOne);
    const double sine = turn[1] / static_cast<double>(kOne);
    for (const auto [x, y] : pixels_of({-20, -20, 20, 20})) {
      const double right = x + 0.5;
      const double up = -0.5 - y;
      const double u = 1024 / size;
      const int32_t distance_q6 = font_builder::disc(
          static_cast<int32_t>((right * cosine + up * sine) * u + 0.5),
          static_cast<int32_t>((up * cosine - right * sine) * u + 0.5));
      const int32_t expected =
          kFilterText.coverage(static_cast<int32_t>(distance_q6 * 16 / u));
      const int32_t error = expected - canvas.at(x, y);
      CHECK(error <= 16 && error >= -16);
    }
  }
}

TEST(moving_by_pixels_moves_the_picture) {
  const GlyphField field = field_of(font_builder::ring);
  const int32_t places[] = {-32767, -32700, -1, 1, 12345, 32767 - kSide};
  for (const auto& turn : kDirections) {
    const Style style = style_of(33 * 64, turn);
    draw_field(field, style, {20200, 20100},
               clear(reference, {0, 0, kSide, kSide}));
    CHECK(reference.ink() > 0);
    for (const int32_t x : places) {
      for (const int32_t y : places) {
        draw_field(field, style,
                   {20200 + int64_t{x} * 1024, 20100 + int64_t{y} * 1024},
                   clear(canvas, {x, y, x + kSide, y + kSide}));
        CHECK(canvas == reference);
      }
    }
  }
}

TEST(origins_anywhere_are_harmless) {
  const GlyphField field = field_of(font_builder::ring);
  Random random(7);
  const int32_t ends[] = {INT32_MIN,  INT32_MIN + 1, -32768 * 64, -1,
                          32767 * 64, INT32_MAX - 1, INT32_MAX};
  for (const int32_t size : each_of({4 * 64, 1024 * 64})) {
    for (const auto& turn : kDirections) {
      const Style style = style_of(size, turn);
      for (int i = 0; i < 60; ++i) {
        const Point origin = {Q26_6::from_raw(ends[random.below(7)]),
                              Q26_6::from_raw(ends[random.below(7)])};
        const int32_t x = (i & 1) != 0 ? -32767 : 32767 - kSide;
        const int32_t y = (i & 2) != 0 ? -32767 : 32767 - kSide;
        check_plain_chain(field, style, origin, {x, y, x + kSide, y + kSide});
      }
    }
  }
}

TEST(the_largest_grids_are_harmless) {
  record.reset();
  record.tile_log2 = 11;
  record.x0_u = -15360;
  record.y0_u = -15360;
  record.tiles_x = 15;
  record.tiles_y = 15;
  record.reference_count = 225;
  for (uint32_t i = 0; i < 225; ++i) {
    record.references[i] = static_cast<uint16_t>(
        i % 3 == 0 ? format::glyph::kCellFlag : i % 3 - 1);
  }
  const int8_t offsets[8] = {-128, 127, -128, 127, 127, -128, 127, -128};
  record.add_raw_cell(INT16_MAX, offsets);
  const GlyphField field = open_glyph();
  CHECK_EQ(field.x1_u(), 15360);
  Random random(12);
  for (const int32_t size :
       each_of({4 * 64, 5 * 64 + 3, 100 * 64, 1024 * 64})) {
    for (const auto& turn : kDirections) {
      const Style style = style_of(size, turn);
      const Rect box = field_box(field, style, {100, 100});
      const auto draw_in = [&field, &style](const Rect& window) {
        draw_field(field, style, {100, 100}, clear(canvas, window));
      };
      const Rect corners[] = {{box.x0 - 1, box.y0 - 1, 0, 0},
                              {box.x1 - kSide + 1, box.y0 - 1, 0, 0},
                              {box.x0 - 1, box.y1 - kSide + 1, 0, 0},
                              {box.x1 - kSide + 1, box.y1 - kSide + 1, 0, 0}};
      for (const Rect& c : corners) {
        draw_in({c.x0, c.y0, c.x0 + kSide, c.y0 + kSide});
      }
      draw_in(window_in(random, box));
    }
  }
}

TEST(nothing_to_draw) {
  const GlyphField field = field_of(font_builder::disc);
  canvas.clear_at(0, 0);
  draw_field(GlyphField{}, style_of(1000), {20000, 20000}, canvas.sink());
  CHECK(is_empty(field_box(GlyphField{}, style_of(1000), {})));
  const Rect windows[] = {{0, 0, 0, 40}, {0, 0, 40, 0}, {40, 40, 0, 0}};
  for (const Rect& window : windows) {
    draw_field(field, style_of(1000), {0, 30000}, canvas.sink(window));
  }
  CHECK_EQ(canvas.ink(), 0);
}

TEST(draws_a_bar_between_pixels) {
  const GlyphField field = field_of(font_builder::bar);
  Picture<10, 14> picture;
  // 16 px: 200..440 u are 3.125..6.875 px, moved by a quarter; 640 u are 10.
  draw_field(field, style_of(16 * 64), {256, 12 * 1024 + 512}, picture.sink());
  CHECK_PICTURE_AT(picture, 3, 2,
                   "++++:\n"
                   "+###:\n"
                   "+###:\n"
                   "+###:\n"
                   "+###:\n"
                   "+###:\n"
                   "+###:\n"
                   "+###:\n"
                   "+###:\n"
                   "+###:\n"
                   "++++:\n");
}

TEST(draws_a_small_disc_upright_and_turned) {
  const GlyphField field = field_of(font_builder::disc);
  Picture<9, 9> upright;
  draw_field(field, style_of(12 * 64), {0, 9 * 1024}, upright.sink());
  CHECK_PICTURE(upright,
                "....:....\n"
                "..+*#*+..\n"
                ".+#####+.\n"
                ".*#####*.\n"
                ":#######:\n"
                ".*#####*.\n"
                ".+#####+.\n"
                "..+*#*+..\n"
                "....:....\n");
  Picture<9, 9> turned;
  draw_field(field, style_of(12 * 64, kDirections[4]), {4608, 11008},
             turned.sink());
  CHECK_PICTURE(turned,
                "...:::...\n"
                "..+*#*+..\n"
                ".+#####+.\n"
                ".*#####*.\n"
                ":#######:\n"
                ".*#####*.\n"
                ".+#####+.\n"
                "..:***:..\n"
                ".........\n");
}

// 2^32 / 1024 px and its multiples, which would wrap.
TEST(far_glyphs_show_nothing) {
  const GlyphField field = field_of(font_builder::disc);
  const Style style = style_of(20 * 64);
  constexpr int64_t kFar = int64_t{1} << 32;
  for (const int64_t way : each_of({kFar, -kFar, 3 * kFar})) {
    canvas.clear_at(0, 0);
    draw_field(field, style, {way, 20 * 1024}, canvas.sink());
    draw_field(field, style, {0, way + 20 * 1024}, canvas.sink());
    CHECK_EQ(canvas.ink(), 0);
    constexpr Rect kScreen = {-32767, -32767, 32767, 32767};
    CHECK(is_empty(intersect(field_box(field, style, {way, 0}), kScreen)));
    CHECK(is_empty(intersect(field_box(field, style, {0, way}), kScreen)));
  }
}
