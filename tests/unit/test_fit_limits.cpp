// Grid fitting: how far edges, bars and stems go, exactly at the limits.
#include "check.hpp"
#include "fitted.hpp"

namespace {

using namespace fitting;

// Heights at 16 px: 16 to the unit. [px, Q10]
constexpr int32_t k16Px = 16 * 64;

// What becomes of the upper edge of a bar that stands on the baseline.
int32_t top_of_bar(int32_t height_u, int32_t px_q6) {
  HintsRecord hints;
  hints.level(0, 1);
  hints.level(height_u, 0);
  hints.zone(0, true);
  hints.edge(0, true);
  hints.edge(1, false);
  const Brush brush = brush_of(px_q6);
  return fitted(make_font(hints.write(2)), brush, {}, {})
      .screen_q10(height_u, brush);
}

// By how much a glyph of one stem or more is moved to the right.
int64_t moved_by_stems(const HintsRecord& record, int32_t px_q6) {
  HintsRecord hints = record;
  hints.level(0, 0);
  hints.edge(0, false);
  FitOptions options;
  options.stems = true;
  return fitted(make_font(hints.write(2)), brush_of(px_q6), options, {})
      .origin.x_q10;
}

}  // namespace

TEST(overshoots_are_cut_off_up_to_0_6_px) {
  HintsRecord hints;
  hints.level(-32, 1);
  hints.level(0, 1);
  hints.zone(1, true);
  hints.edge(0, false);
  hints.edge(1, false);
  const Font font = make_font(hints.write(2));
  // 613/1024 px; the flat edge goes a step above it.
  Brush brush = brush_of(1226);
  Fitted glyph = fitted(font, brush, {}, {});
  CHECK_EQ(glyph.screen_q10(-32, brush), 0);
  CHECK_EQ(glyph.screen_q10(0, brush), RowMap::kLeastStepQ10);
  // 614/1024 px: both stay.
  brush = brush_of(1228);
  glyph = fitted(font, brush, {}, {});
  CHECK_EQ(glyph.screen_q10(-32, brush), -kPx);
  CHECK_EQ(glyph.screen_q10(0, brush), 0);
}

TEST(upper_zones_go_up_from_3_8_px) {
  constexpr struct {
    int32_t height_u;
    int32_t px_q6;
    int32_t screen_px;
  } kZones[] = {{512, 688, 6},   // 5 px and 384/1024
                {509, 692, 5}};  // 5 px and 383/1024
  for (const auto& zone : kZones) {
    HintsRecord hints;
    hints.level(zone.height_u, 1);
    hints.zone(0, false);
    hints.edge(0, false);
    const Brush brush = brush_of(zone.px_q6);
    CHECK_EQ(fitted(make_font(hints.write(2)), brush, {}, {})
                 .screen_q10(zone.height_u, brush),
             zone.screen_px * kPx);
  }
}

TEST(strokes_become_whole_rows_if_they_need_not_change_much) {
  CHECK_EQ(top_of_bar(10, k16Px), kPx);
  // 1.25 px, and 1/1024 more.
  CHECK_EQ(top_of_bar(64, 1280), kPx);
  CHECK_EQ(top_of_bar(64, 1281), 1281);
  // 1.75 px, and 1/1024 less.
  CHECK_EQ(top_of_bar(112, k16Px), 2 * kPx);
  CHECK_EQ(top_of_bar(111, 1033), 1791);
  // 2.25 px, and 1/1024 more.
  CHECK_EQ(top_of_bar(144, k16Px), 2 * kPx);
  CHECK_EQ(top_of_bar(143, 1032), 2305);
}

TEST(free_bars_go_to_the_nearest_rows) {
  const Brush brush = brush_of(k16Px);
  // The middle at 4 px, and 1/128 px below: 3.5 px is nearer to 4 px.
  for (int32_t lower = 0; lower < 2; ++lower) {
    HintsRecord hints;
    hints.level(221 - lower, 0);
    hints.level(291, 0);
    hints.edge(0, true);
    hints.edge(1, false);
    const Fitted glyph = fitted(make_font(hints.write(2)), brush, {}, {});
    CHECK_EQ(glyph.screen_q10(221 - lower, brush), (4 - lower) * kPx);
    CHECK_EQ(glyph.screen_q10(291, brush), (5 - lower) * kPx);
  }
}

TEST(free_bars_keep_3_4_px_of_the_space_below) {
  HintsRecord hints;
  hints.level(0, 1);
  hints.level(64, 0);
  hints.level(103, 0);
  hints.level(163, 0);
  hints.zone(0, true);
  hints.edge(0, true);
  hints.edge(1, false);
  hints.edge(2, true);
  hints.edge(3, false);
  // The lower bar ends at 1281: up to row 2 there are 767/1024 px.
  const Brush brush = brush_of(1281);
  const Fitted glyph = fitted(make_font(hints.write(2)), brush, {}, {});
  CHECK_EQ(glyph.screen_q10(64, brush), 1281);
  CHECK_EQ(glyph.screen_q10(103, brush), 3 * kPx);
  CHECK_EQ(glyph.screen_q10(163, brush), 4 * kPx);
  // With a roof there is no other place.
  hints.level(200, 2);
  hints.zone(4, false);
  hints.edge(4, false);
  const Fitted under = fitted(make_font(hints.write(2)), brush, {}, {});
  CHECK_EQ(under.screen_q10(200, brush), 4 * kPx);
  CHECK_EQ(under.screen_q10(103, brush), INT32_MAX);
  CHECK_EQ(under.screen_q10(163, brush), INT32_MAX);
}

TEST(free_bars_keep_3_4_px_of_the_space_above) {
  HintsRecord hints;
  hints.level(255, 0);
  hints.level(359, 0);
  hints.level(408, 0);
  hints.level(512, 1);
  hints.zone(3, false);
  hints.edge(0, true);
  hints.edge(1, false);
  hints.edge(2, true);
  hints.edge(3, false);
  // Both bars are 1664/1024 px high: 3/4 px are left between them.
  const Brush brush = brush_of(k16Px);
  const Fitted glyph = fitted(make_font(hints.write(2)), brush, {}, {});
  CHECK_EQ(glyph.screen_q10(512, brush), 8 * kPx);
  CHECK_EQ(glyph.screen_q10(408, brush), 8 * kPx - 1664);
  CHECK_EQ(glyph.screen_q10(255, brush), 4 * kPx);
  CHECK_EQ(glyph.screen_q10(359, brush), 4 * kPx + 1664);
}

// A zone that goes up by 3/8 px takes what is below it along, all of it or the
// share that the way to another zone leaves.
TEST(free_bars_go_where_zones_around_them_go) {
  const Brush brush = brush_of(k16Px);
  for (int baseline = 0; baseline < 2; ++baseline) {
    HintsRecord hints;
    hints.level(0, baseline == 0 ? 0 : 2);
    hints.level(baseline == 0 ? 200 : 216, 0);
    hints.level(baseline == 0 ? 270 : 286, 0);
    hints.level(488, 1);
    hints.zone(3, false);
    hints.zone(0, true);
    hints.edge(0, false);
    hints.edge(1, true);
    hints.edge(2, false);
    hints.edge(3, false);
    const Fitted glyph = fitted(make_font(hints.write(2)), brush, {}, {});
    CHECK_EQ(glyph.screen_q10(488, brush), 8 * kPx);
    const int32_t bar = glyph.screen_q10(baseline == 0 ? 200 : 216, brush);
    // Rounded from 3632, and from 3701: not from 3248 and 3504.
    CHECK_EQ(bar, 4 * kPx);
  }
}

TEST(bars_end_behind_the_edges_of_their_zone) {
  const Brush brush = brush_of(12 * 64);
  HintsRecord low;
  low.level(-14, 1);
  low.level(0, 1);
  low.level(70, 0);
  low.zone(1, true);
  low.edge(0, true);
  low.edge(1, false);
  low.edge(2, false);
  CHECK_EQ(fitted(make_font(low.write(2)), brush, {}, {}).screen_q10(70, brush),
           kPx);
  // 1656 and 1380/1024 px below the upper edges of the zone.
  const Brush large = brush_of(23 * 64);
  HintsRecord high;
  high.level(440, 0);
  high.level(500, 1);
  high.level(512, 1);
  high.zone(1, false);
  high.edge(0, true);
  high.edge(1, false);
  high.edge(2, false);
  const Fitted glyph = fitted(make_font(high.write(2)), large, {}, {});
  const int32_t zone = glyph.screen_q10(512, large);
  CHECK_EQ(zone % kPx, 0);
  CHECK_EQ(glyph.screen_q10(500, large), zone - RowMap::kLeastStepQ10);
  CHECK_EQ(glyph.screen_q10(440, large), zone - 1656);
}

TEST(two_edges_of_an_upper_zone_stay_a_step_apart) {
  HintsRecord hints;
  hints.level(500, 1);
  hints.level(505, 1);
  hints.zone(0, false);
  hints.edge(0, false);
  hints.edge(1, false);
  const Brush brush = brush_of(12 * 64);
  const Fitted glyph = fitted(make_font(hints.write(2)), brush, {}, {});
  CHECK_EQ(glyph.screen_q10(505, brush), 6 * kPx);
  CHECK_EQ(glyph.screen_q10(500, brush), 6 * kPx - RowMap::kLeastStepQ10);
}

TEST(a_bar_without_an_upper_edge_moves_nothing) {
  HintsRecord hints;
  hints.level(69, 0);
  hints.level(87, 1);
  hints.zone(1, true);
  hints.edge(0, false);
  hints.edge(1, true);
  const Brush brush = brush_of(k16Px);
  const Fitted glyph = fitted(make_font(hints.write(2)), brush, {}, {});
  CHECK_EQ(glyph.screen_q10(87, brush), kPx);
  CHECK_EQ(glyph.rows.count, 1);
}

// font.verify() refuses them; nothing is divided by the way between them.
TEST(edges_of_one_height_are_survived) {
  HintsRecord hints;
  for (uint32_t i = 0; i < 4; ++i) {
    hints.level(100, i % 3 == 0 ? 1 : 0);
    hints.edge(i, i == 1);
  }
  hints.zone(0, true);
  const Font font = make_font(hints.write(2));
  CHECK_EQ(font.verify(), Status::corrupt);
  const Brush brush = brush_of(k16Px);
  const Fitted glyph = fitted(font, brush, {}, {});
  CHECK_EQ(glyph.screen_q10(100, brush), 2 * kPx);
  CHECK_EQ(glyph.rows.count, 1);
}

TEST(ten_edges_are_read) {
  HintsRecord hints;
  for (uint32_t i = 0; i < RowMap::kMaxKnots - 1; ++i) {
    hints.level(static_cast<int32_t>(50 * i), 0);
    hints.edge(i, false);
  }
  hints.level(520, 1);
  hints.zone(RowMap::kMaxKnots - 1, false);
  hints.edge(RowMap::kMaxKnots - 1, false);
  const Font font = make_font(hints.write(2));
  CHECK_OK(font.verify());
  const Brush brush = brush_of(12 * 64);
  CHECK_EQ(fitted(font, brush, {}, {}).screen_q10(520, brush), 6 * kPx);
}

TEST(edges_of_levels_that_do_not_exist_end_the_list) {
  HintsRecord hints;
  hints.level(0, 1);
  hints.zone(0, true);
  hints.edge(0, true);
  // The bytes there would be an edge far above the bar.
  hints.edge(1, false);
  const Font font = make_font(hints.write(2));
  CHECK_EQ(font.verify(), Status::corrupt);
  CHECK_EQ(fitted(font, brush_of(k16Px), {}, {}).rows.count, 1);
}

TEST(strength_fades_from_24_to_40_px) {
  const Font font = usual_font();
  constexpr struct {
    int32_t px_q6;
    int32_t strength_q8;
  } kSizes[] = {{24 * 64, 256},
                {24 * 64 + 4, 255},
                {24 * 64 + 32, 248},
                {40 * 64 - 4, 1},
                {40 * 64 - 3, 0}};
  for (const auto& size : kSizes) {
    const Fitted glyph = fitted(font, brush_of(size.px_q6), {}, {0, 256});
    CHECK_EQ(glyph.origin.y_q10, 256 - size.strength_q8);
  }
}

TEST(a_fit_moves_nothing_at_sizes_that_are_not_fitted) {
  const Font font = usual_font();
  Fit fit;
  CHECK_OK(Fit::make(font, brush_of(20 * 64), {}, fit));
  GlyphField field;
  field.glyph = 1;
  FinePoint origin = {300, 400};
  RowMap rows;
  fit_glyph(field.glyph, brush_of(40 * 64), &fit, origin, rows);
  CHECK_EQ(origin.y_q10, 400);
  CHECK_EQ(rows.count, 0);
  fit_glyph(field.glyph, brush_of(40 * 64 - 1), &fit, origin, rows);
  CHECK_EQ(origin.y_q10, 0);
  CHECK(rows.count > 0);
}

TEST(stems_are_moved_up_to_2_5_px_of_width) {
  HintsRecord hints;
  hints.stem = 31;
  hints.stem_width_u = 128;
  CHECK(moved_by_stems(hints, 1280) != 0);
  // 2.5 px and 1/1024.
  hints.stem_width_u = 127;
  CHECK_EQ(moved_by_stems(hints, 1291), 0);
}

TEST(stems_go_to_the_middle_of_their_pixels) {
  HintsRecord hints;
  // Stems in the middle of a pixel, less 1/16 px.
  hints.stem = 7;
  hints.stem_width_u = 64;
  CHECK_EQ(moved_by_stems(hints, k16Px), 64);
  // As thin as they get: still one pixel.
  hints.stem_width_u = 10;
  CHECK_EQ(moved_by_stems(hints, k16Px), 64);
  // Two pixels, which meet 7/16 px to the left of where it stands.
  hints.stem_width_u = 128;
  CHECK_EQ(moved_by_stems(hints, k16Px), -256);
  hints.stem = 1;
  CHECK_EQ(moved_by_stems(hints, k16Px), -64);
}

TEST(stems_share_what_each_would_take) {
  HintsRecord hints;
  hints.stem_width_u = 64;
  hints.stem = 6;
  hints.gap = 15;
  // 128 and 192.
  CHECK_EQ(moved_by_stems(hints, k16Px), 160);
}

// The first takes 5/16 px to the right, the second 9/16 px, which is 7/16 px to
// the left: the mean is taken of two ways to the right.
TEST(stems_go_the_same_way) {
  HintsRecord hints;
  hints.stem_width_u = 64;
  hints.stem = 3;
  hints.gap = 12;
  CHECK_EQ(moved_by_stems(hints, k16Px), 256);
}

TEST(glyphs_without_a_list_are_not_moved_sideways) {
  HintsRecord hints;
  hints.level(0, 0);
  hints.edge(0, false);
  hints.stem = 7;
  FitOptions options;
  options.stems = true;
  const Span<const uint8_t> all = hints.write(2);
  const Brush brush = brush_of(k16Px);
  CHECK(fitted(make_font(all), brush, options, {}).origin.x_q10 != 0);
  const Font cut = make_font({all.data, all.size - 1});
  CHECK_EQ(fitted(cut, brush, options, {}).origin.x_q10, 0);
}
