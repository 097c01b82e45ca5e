// Grid fitting: where edges go, how far, and what hostile hints can do.
#include "check.hpp"
#include "fitted.hpp"
#include "inkcell/text.hpp"
#include "picture.hpp"
#include "random.hpp"

using namespace fitting;

TEST(hints_read_as_they_were_written) {
  const Font font = usual_font();
  CHECK_OK(font.verify());
  Hints hints;
  CHECK_OK(Hints::open(font, hints));
  CHECK_EQ(hints.level_count(), 6);
  CHECK_EQ(hints.level(0).height_u, -14);
  CHECK_EQ(hints.level(0).zone, 1);
  CHECK_EQ(hints.level(3).height_u, 270);
  CHECK_EQ(hints.level(3).zone, 0);
  CHECK_EQ(hints.zone_count(), 2);
  CHECK_EQ(hints.zone(0).height_u, 0);
  CHECK(hints.zone(0).is_bottom && !hints.zone(1).is_bottom);
  CHECK_EQ(hints.zone(1).height_u, 512);
  Span<const uint8_t> edges;
  CHECK(hints.edges(1, edges));
  CHECK_EQ(edges.size, 6);
  CHECK_EQ(Hints::edge(edges[2]).level, 2);
  CHECK(Hints::edge(edges[2]).is_bar);
  CHECK(!Hints::edge(edges[3]).is_bar);
  CHECK_EQ(hints.stems(1).first_u, 120);
  CHECK_EQ(hints.stems(1).gap_u, 240);
  CHECK_EQ(hints.stems(1).count, 3);
  CHECK(!hints.edges(2, edges));
  CHECK_EQ(edges.size, 0);
  CHECK_EQ(hints.stems(2).count, 0);
}

TEST(edges_of_zones_and_bars_lie_between_rows) {
  const Font font = usual_font();
  // 11 px: the zone is 5.5 px high, bars are 0.8 px.
  constexpr int32_t kSizes[] = {10 * 64, 11 * 64 + 10, 12 * 64, 14 * 64};
  for (const int32_t px_q6 : kSizes) {
    const Brush brush = brush_of(px_q6);
    const Fitted glyph = fitted(font, brush, {}, {});
    const int32_t zone = glyph.screen_q10(512, brush);
    // Upwards from 3/8 px on.
    CHECK_EQ(zone, (px_q6 * 8 + kPx * 5 / 8) / kPx * kPx);
    CHECK_EQ(glyph.screen_q10(440, brush), zone - kPx);
    // The overshoot is cut off, and the flat edge a step above it.
    CHECK_EQ(glyph.screen_q10(-14, brush), 0);
    CHECK_EQ(glyph.screen_q10(0, brush), RowMap::kLeastStepQ10);
    const int32_t bar = glyph.screen_q10(200, brush);
    CHECK_EQ(bar % kPx, 0);
    CHECK_EQ(glyph.screen_q10(270, brush), bar + kPx);
    CHECK(bar >= kPx && bar <= zone - 3 * kPx);
  }
}

TEST(a_bar_without_room_is_left_to_what_is_around_it) {
  const Font font = usual_font();
  // At 6 px the zone is 3 px high: one row is free, and it must stay so.
  const Brush brush = brush_of(6 * 64);
  const Fitted glyph = fitted(font, brush, {}, {});
  CHECK_EQ(glyph.screen_q10(512, brush), 3 * kPx);
  CHECK_EQ(glyph.screen_q10(440, brush), 2 * kPx);
  CHECK_EQ(glyph.screen_q10(200, brush), INT32_MAX);
}

TEST(wide_overshoots_stay) {
  HintsRecord hints;
  hints.level(0, 1);
  hints.level(500, 2);
  hints.level(530, 2);
  hints.zone(0, true);
  hints.zone(1, false);
  hints.edge(0, false);
  hints.edge(1, false);
  hints.edge(2, false);
  const Font round = make_font(hints.write(2));
  // 30 u are 0.59 px at 20 px and 0.62 px at 21 px.
  Brush brush = brush_of(20 * 64);
  CHECK_EQ(fitted(round, brush, {}, {}).screen_q10(530, brush), 10 * kPx);
  brush = brush_of(21 * 64 + 10);
  CHECK_EQ(fitted(round, brush, {}, {}).screen_q10(530, brush), 11 * kPx);
}

TEST(baselines_lie_between_rows) {
  const Font plain = make_font({});
  const Brush brush = brush_of(12 * 64);
  constexpr int64_t kHeights[] = {0, 511, 512, 1023, -1, -512, -513};
  for (const int64_t y : kHeights) {
    const Fitted glyph = fitted(plain, brush, {}, {300, y});
    CHECK_EQ(glyph.origin.y_q10 % kPx, 0);
    CHECK(glyph.origin.y_q10 - y <= kPx / 2 && y - glyph.origin.y_q10 < kPx);
    CHECK_EQ(glyph.origin.x_q10, 300);
    CHECK_EQ(glyph.rows.count, 0);
  }
}

TEST(strength_and_size_let_go) {
  const Font font = usual_font();
  const Brush brush = brush_of(11 * 64);
  const FinePoint origin = {0, 400};
  FitOptions options;
  const Fitted all = fitted(font, brush, options, origin);
  options.strength_q8 = 128;
  const Fitted half = fitted(font, brush, options, origin);
  CHECK_EQ(all.origin.y_q10, 0);
  CHECK_EQ(half.origin.y_q10, 200);
  const int32_t zone = 11 * kPx / 2;
  CHECK_EQ(all.screen_q10(512, brush), zone + kPx / 2);
  CHECK_EQ(half.screen_q10(512, brush), zone + kPx / 4);
  options.strength_q8 = 0;
  const Fitted none = fitted(font, brush, options, origin);
  CHECK_EQ(none.origin.y_q10, 400);
  CHECK_EQ(none.rows.count, 0);
  options.strength_q8 = FitOptions::kAll;
  const Brush middle = brush_of(32 * 64 + 31);
  const Fitted fading = fitted(font, middle, options, origin);
  CHECK(fading.origin.y_q10 > 100 && fading.origin.y_q10 < 300);
  const Fitted large = fitted(font, brush_of(40 * 64), options, origin);
  CHECK_EQ(large.origin.y_q10, 400);
  CHECK_EQ(large.rows.count, 0);
  options.strength_q8 = FitOptions::kAll + 1;
  Fit fit;
  CHECK_EQ(Fit::make(font, brush, options, fit), Status::bad_argument);
}

TEST(stems_go_to_the_middle_of_pixels) {
  HintsRecord hints;
  hints.level(0, 0);
  hints.edge(0, false);
  hints.stem = 32;  // 128 u: 1.5 px at 12 px
  const Font font = make_font(hints.write(2));
  const Brush brush = brush_of(12 * 64);
  FitOptions options;
  options.stems = true;
  for (int64_t x = -700; x < 700; x += 100) {
    const Fitted glyph = fitted(font, brush, options, {x, 0});
    const int64_t moved = glyph.origin.x_q10 - x;
    const int64_t before = x & (kPx - 1);
    const int64_t wanted = before >= kPx / 2 ? kPx - before : -before;
    CHECK_EQ(moved, wanted > 256 ? 256 : wanted < -256 ? -256 : wanted);
  }
  options.stems = false;
  CHECK_EQ(fitted(font, brush, options, {100, 0}).origin.x_q10, 100);
}

// A bar 0.6 px high, across two rows as designed and in one when fitted.
TEST(pictures_are_sharper) {
  const Font font = usual_font();
  const Point origin = {Q26_6::from_int(0), Q26_6::from_raw(9 * 64 + 24)};
  Brush brush = brush_of(12 * 64);
  Picture<8, 12> plain;
  draw_glyph(font, 1, brush, origin, plain.sink());
  Fit fit;
  CHECK_OK(Fit::make(font, brush, {}, fit));
  brush.set_fitter(fit_glyph, &fit);
  Picture<8, 12> sharp;
  draw_glyph(font, 1, brush, origin, sharp.sink());
  // The lower end lies on the baseline.
  CHECK(plain.at(3, 9) > 0 && plain.at(3, 9) < 255);
  CHECK_EQ(sharp.at(3, 8), 255);
  CHECK_EQ(sharp.at(3, 9), 0);
}

namespace {

// What a picture shows, in one number. One at a time is all that boards have
// the stack for.
__attribute__((noinline)) uint32_t sum_of_picture(const Font& font,
                                                  const Brush& brush,
                                                  Point origin) {
  Picture<24, 34> picture;
  draw_glyph(font, 1, brush, origin, picture.sink());
  CHECK(picture.at(12, 20) > 0);
  uint32_t sum = 2166136261u;
  for (int32_t i = 0; i < 24 * 34; ++i) {
    sum = (sum ^ picture.at(i % 24, i / 24)) * 16777619u;
  }
  return sum;
}

}  // namespace

// Where nothing is fitted any more, glyphs are what they are without.
TEST(large_pictures_stay) {
  const Font font = usual_font();
  Brush brush = brush_of(40 * 64);
  Fit fit;
  CHECK_OK(Fit::make(font, brush, {}, fit));
  for (int32_t y = 30 * 64; y < 31 * 64; y += 7) {
    const Point origin = {Q26_6::from_raw(y % 64), Q26_6::from_raw(y)};
    brush.set_fitter(nullptr, nullptr);
    const uint32_t plain = sum_of_picture(font, brush, origin);
    brush.set_fitter(fit_glyph, &fit);
    CHECK_EQ(sum_of_picture(font, brush, origin), plain);
  }
}

namespace {

// A section of any bytes.
Span<const uint8_t> noise_of(Random& random) {
  static uint8_t bytes[100];
  for (uint8_t& byte : bytes) {
    byte = static_cast<uint8_t>(random.byte());
  }
  bytes[format::hints::kLevels] = static_cast<uint8_t>(random.below(20));
  bytes[format::hints::kZones] = static_cast<uint8_t>(random.below(16));
  bytes[format::hints::kStartBits] = static_cast<uint8_t>(random.below(4));
  bytes[format::hints::kCountBits] = static_cast<uint8_t>(random.below(5));
  bytes[format::hints::kStemBits] = static_cast<uint8_t>(random.below(14));
  bytes[format::hints::kGapBits] = static_cast<uint8_t>(random.below(14));
  return bytes;
}

// A section whose heights ascend more often than not.
Span<const uint8_t> disorder_of(Random& random, HintsRecord& record) {
  int32_t height = random.between(-300, 0);
  const uint32_t zones = random.below(4);
  for (uint32_t i = 0; i < 12; ++i) {
    record.level(height, random.below(5));
    height += random.between(-20, 150);
  }
  for (uint32_t i = 0; i < zones; ++i) {
    record.zone(random.below(14), random.below(2) == 0);
  }
  for (uint32_t i = 0; i < 12; ++i) {
    record.edge(i + (random.below(9) == 0 ? 1 : 0), random.below(3) != 0);
  }
  record.stem = random.below(256);
  record.gap = random.below(256);
  record.has_third = random.below(2) != 0;
  record.stem_base_u = random.between(-32768, 32767);
  return record.write(2);
}

}  // namespace

// Whatever the section says.
TEST(hostile_hints_break_no_promise) {
  Random random(41);
  int fits = 0;
  int knots = 0;
  const int rounds = INKCELL_BOARD_FIRMWARE ? 200 : 20000;
  for (int round = 0; round < rounds && !check::failed(); ++round) {
    HintsRecord record;
    const Font font = make_font(round % 2 == 0 ? noise_of(random)
                                               : disorder_of(random, record));
    static_cast<void>(font.verify() == Status::ok);
    const Brush brush = brush_of(random.between(4 * 64, 48 * 64));
    FitOptions options;
    options.stems = round % 3 != 0;
    options.strength_q8 = static_cast<uint16_t>(random.below(257));
    Fit fit;
    if (Fit::make(font, brush, options, fit) != Status::ok) {
      continue;
    }
    ++fits;
    GlyphField field;
    field.glyph = static_cast<uint16_t>(random.below(3));
    const FinePoint origin = {random.between(-99999, 99999),
                              random.between(-99999, 99999)};
    FinePoint moved = origin;
    RowMap rows;
    fit_glyph(field.glyph, brush, &fit, moved, rows);
    CHECK(moved.x_q10 - origin.x_q10 <= kPx / 4);
    CHECK(origin.x_q10 - moved.x_q10 <= kPx / 4);
    CHECK(moved.y_q10 - origin.y_q10 <= kPx / 2);
    CHECK(origin.y_q10 - moved.y_q10 <= kPx / 2);
    knots += rows.count;
    // Both together move nothing by more than 1 px, but for a rounding.
    for (uint32_t i = 0; i < rows.count; ++i) {
      const int64_t lowered = moved.y_q10 - origin.y_q10 -
                              rows.knots[i].screen_q10 +
                              rows.knots[i].glyph_q10;
      CHECK(lowered <= kPx + 2 && lowered >= -kPx - 2);
    }
    for (uint32_t i = 1; i < rows.count; ++i) {
      CHECK(rows.knots[i].screen_q10 > rows.knots[i - 1].screen_q10);
      CHECK(rows.knots[i].glyph_q10 > rows.knots[i - 1].glyph_q10);
    }
  }
  CHECK(fits > rounds / 2 && knots > rounds);
}

TEST(a_section_that_does_not_fit_is_corrupt) {
  HintsRecord record;
  record.make_usual();
  const Span<const uint8_t> good = record.write(2);
  Hints hints;
  for (uint32_t size = 1; size < good.size; ++size) {
    const Font font = make_font({good.data, size});
    CHECK(font.verify() == Status::corrupt);
    const bool opens = Hints::open(font, hints) == Status::ok;
    // Header, levels, zones and rows; lists are looked at when they are used.
    CHECK_EQ(opens, size >= 10 + 12 + 2 + 6);
  }
  Fit fit;
  const Font cut = make_font({good.data, 9});
  CHECK_EQ(Fit::make(cut, Brush(), {}, fit), Status::corrupt);
  CHECK_OK(Fit::make(make_font({}), Brush(), {}, fit));
}
