// Crisp text: two and four levels, and strokes that stay whole.
#include "check.hpp"
#include "field_record.hpp"
#include "inkcell/crisp.hpp"
#include "picture.hpp"

#if INKCELL_EDGE_CELLS

namespace {

using namespace inkcell;

alignas(4) uint8_t bytes[256];

// A straight stroke across a tile: min of two planes, its middle at `c_u` along
// the normal (nx, ny), Q14.
GlyphField stroke(int32_t nx, int32_t ny, int32_t c_u, int32_t width_u) {
  FieldRecord record;
  record.tile_log2 = 10;
  record.line_count = 2;
  record.pair_count = 1;
  record.pairs[0][1] = 1;
  record.references[0] = record.pair_reference(0);
  record.fields[0] = {nx, ny, -16 * c_u + 8 * width_u, 0, 0};
  record.fields[1] = {-nx, -ny, 16 * c_u + 8 * width_u, 0, 0};
  record.write(bytes);
  GlyphField field;
  CHECK_OK(GlyphField::open({bytes, record.size()}, field));
  return field;
}

TextStyle style_of(int32_t px, const CrispOptions& crisp) {
  TextStyle style;
  CHECK_OK(TextStyle::make(Q26_6::from_int(px), kFilterText, style));
  style.set_effect(crisp_effect(crisp));
  return style;
}

constexpr int32_t kSide = 12;

using Drawing = Picture<kSide, kSide>;

// Whether every column (or row) within the tile's middle has a pixel, and each
// touches the one before.
bool is_connected(const Drawing& drawing, bool by_columns) {
  int32_t last_low = -1;
  int32_t last_high = -1;
  for (int32_t i = 2; i < kSide - 2; ++i) {
    int32_t low = kSide;
    int32_t high = -1;
    for (int32_t j = 0; j < kSide; ++j) {
      const uint8_t coverage = by_columns ? drawing.at(i, j) : drawing.at(j, i);
      if (coverage >= 170) {
        low = low < j ? low : j;
        high = j;
      }
    }
    const bool touches =
        last_low < 0 || (low <= last_high + 1 && high >= last_low - 1);
    if (high < 0 || !touches) {
      return false;
    }
    last_low = low;
    last_high = high;
  }
  return true;
}

}  // namespace

// Strokes of 0.2 to 1 px in many directions and places, at 12 px.
TEST(thin_strokes_stay_connected) {
  constexpr int32_t kNormals[][2] = {
      {16384, 0},     {0, 16384},      {16069, 3196},  {15137, 6270},
      {11585, 11585}, {-11585, 11585}, {13623, -9102}, {-6270, 15137},
      {9102, 13623},  {-3196, 16069}};
  constexpr uint8_t kLevels[] = {2, 4};
  for (const uint8_t levels : kLevels) {
    const CrispOptions crisp = {levels, {}};
    const TextStyle style = style_of(12, crisp);
    for (const auto& normal : kNormals) {
      for (int32_t width_u = 17; width_u <= 85; width_u += 17) {
        for (int32_t shift = 0; shift < 85; shift += 9) {
          const int32_t middle_u = (normal[0] + normal[1]) * 512 / 16384;
          const GlyphField field =
              stroke(normal[0], normal[1], middle_u + shift, width_u);
          Drawing drawing;
          draw_field(field, style, {0, 12 << 10}, drawing.sink());
          const bool by_columns = normal[1] * normal[1] > normal[0] * normal[0];
          CHECK(is_connected(drawing, by_columns));
          if (check::failed()) {
            drawing.print();
            return;
          }
        }
      }
    }
  }
}

// Where strokes are wide enough nothing is added to what the threshold says.
TEST(wide_strokes_are_what_the_threshold_says) {
  for (int32_t threshold = -256; threshold <= 256; threshold += 128) {
    CrispOptions crisp;
    crisp.threshold_px.raw = static_cast<int16_t>(threshold);
    const TextStyle style = style_of(12, crisp);
    for (int32_t shift = 0; shift < 85; shift += 5) {
      const GlyphField field = stroke(16069, 3196, 500 + shift, 250);
      Drawing drawing;
      const FinePoint origin(0, 12 << 10);
      draw_field(field, style, origin, drawing.sink());
      for (int32_t y = 0; y < kSide; ++y) {
        Q6_10 row[kSide];
        distance_row(field, style, origin, 0, y, {row, kSide});
        for (int32_t x = 0; x < kSide; ++x) {
          CHECK_EQ(drawing.at(x, y), row[x].raw >= threshold ? 255 : 0);
        }
      }
    }
  }
}

// Whatever the filter shows: also where its ramp begins inside the ink.
TEST(two_levels_ask_nothing_of_the_filter) {
  CrispOptions crisp;
  crisp.threshold_px.raw = -512;
  GlyphField field = stroke(0, 16384, 500, 250);
  field.ink = {0, 375, 1024, 625};
  for (int32_t shift_q10 = 0; shift_q10 < 1024; shift_q10 += 64) {
    const FinePoint origin(0, (12 << 10) + shift_q10);
    Drawing expected;
    draw_field(field, style_of(12, crisp), origin, expected.sink());
    CHECK(expected.at(5, 6) == 255);
    for (int32_t outside_q10 = 512; outside_q10 <= 2048; outside_q10 += 512) {
      Filter thin = kFilterText;
      thin.outside_q10 = static_cast<int16_t>(outside_q10);
      thin.inside_q10 = static_cast<int16_t>(outside_q10 + 1024);
      TextStyle style;
      CHECK_OK(TextStyle::make(Q26_6::from_int(12), thin, style));
      style.set_effect(crisp_effect(crisp));
      Drawing drawing;
      draw_field(field, style, origin, drawing.sink());
      for (int32_t y = 0; y < kSide; ++y) {
        for (int32_t x = 0; x < kSide; ++x) {
          CHECK_EQ(drawing.at(x, y), expected.at(x, y));
        }
      }
    }
  }
}

TEST(four_levels_are_the_nearest) {
  const CrispOptions crisp = {4, {}};
  const TextStyle style = style_of(12, crisp);
  const GlyphField field = stroke(13623, -9102, 150, 250);
  Drawing drawing;
  const FinePoint origin(0, 12 << 10);
  draw_field(field, style, origin, drawing.sink());
  int32_t greys = 0;
  for (int32_t y = 0; y < kSide; ++y) {
    Q6_10 row[kSide];
    distance_row(field, style, origin, 0, y, {row, kSide});
    for (int32_t x = 0; x < kSide; ++x) {
      const int32_t level = drawing.at(x, y);
      const int32_t error = level - kFilterText.coverage(row[x].raw);
      CHECK_EQ(level % 85, 0);
      CHECK(error >= -42 && error <= 42);
      greys += level == 85 || level == 170 ? 1 : 0;
    }
  }
  CHECK(greys > 4);
}

// A stroke that ends between two rows is not prolonged.
TEST(ends_of_strokes_are_not_prolonged) {
  const CrispOptions crisp;
  const TextStyle style = style_of(16, crisp);
  FieldRecord record;
  record.tile_log2 = 10;
  record.line_count = 3;
  record.triple_count = 1;
  // Upright, 0.6 px wide, and ending at 8.4 px.
  record.triples[0][2] = 1;
  record.triples[0][3] = 2;
  record.references[0] = record.triple_reference(0);
  record.fields[0] = {16384, 0, -16 * 301, 0, 0};
  record.fields[1] = {-16384, 0, 16 * 339, 0, 0};
  record.fields[2] = {0, -16384, 16 * 538, 0, 0};
  record.write(bytes);
  GlyphField field;
  CHECK_OK(GlyphField::open({bytes, record.size()}, field));
  for (int32_t shift = 0; shift < 1024; shift += 100) {
    Picture<16, 16> drawing;
    draw_field(field, style, {shift, 16 << 10}, drawing.sink());
    for (int32_t y = 0; y < 16; ++y) {
      int32_t drawn = 0;
      for (int32_t x = 0; x < 16; ++x) {
        drawn += drawing.at(x, y) != 0 ? 1 : 0;
      }
      CHECK_EQ(drawn, y >= 8 ? 1 : 0);
    }
  }
}

namespace {

// Where the stroke's middle lies between two pixels of 16.
constexpr int32_t kMiddle_u = 512;

// A picture of 16 px, and the seventh and eighth pixel across the stroke.
struct Crossing {
  Picture<16, 16> picture;

  Crossing(const GlyphField& field,
           const TextStyle& style,
           int32_t shift_q10 = 0) {
    draw_field(field, style, {shift_q10, 16 << 10}, picture.sink());
  }
  uint8_t left() const { return picture.at(7, 7); }
  uint8_t right() const { return picture.at(8, 7); }
};

}  // namespace

TEST(of_two_that_are_equally_near_the_left_or_upper_is_drawn) {
  const CrispOptions crisp;
  const TextStyle style = style_of(16, crisp);
  // Also strokes of no width.
  constexpr int32_t kWidths[] = {26, 0};
  for (const int32_t width_u : kWidths) {
    const Crossing upright(stroke(16384, 0, kMiddle_u, width_u), style);
    CHECK_EQ(upright.left(), 255);
    CHECK_EQ(upright.right(), 0);
    const Crossing level(stroke(0, 16384, kMiddle_u, width_u), style);
    CHECK_EQ(level.picture.at(7, 7), 255);
    CHECK_EQ(level.picture.at(7, 8), 0);
  }
}

TEST(a_bridge_is_the_third_of_four_levels_at_least) {
  const CrispOptions crisp = {4, {}};
  TextStyle style = style_of(16, crisp);
  const GlyphField field = stroke(16384, 0, kMiddle_u, 26);
  const Crossing usual(field, style);
  CHECK_EQ(usual.left(), 170);
  CHECK_EQ(usual.right(), 85);
  // A bold filter has more than that to say.
  const Filter bold = with_weight(kFilterText, Q6_10::from_raw(700));
  CHECK_OK(TextStyle::make(Q26_6::from_int(16), bold, style));
  style.set_effect(crisp_effect(crisp));
  CHECK_EQ(Crossing(field, style).left(), 255);
  // A light one is not overruled where the centre is in the ink.
  const Filter light = with_weight(kFilterText, Q6_10::from_raw(-300));
  CHECK_OK(TextStyle::make(Q26_6::from_int(16), light, style));
  style.set_effect(crisp_effect(crisp));
  CHECK_EQ(Crossing(field, style, 500).right(), 85);
}

// Two edges that meet in a narrow point: what passes close to the neighbour is
// found as well, since the nearer edge leans.
TEST(points_are_found_far_from_the_pixel) {
  FieldRecord record;
  record.tile_log2 = 10;
  record.line_count = 2;
  record.pair_count = 1;
  record.pairs[0][1] = 1;
  record.references[0] = record.pair_reference(0);
  // At row 7 from 8 px and 1/32 on, 1/32 px wide.
  record.fields[0] = {13107, 9830, 0, 0, 0};
  record.fields[0].c = -(13107 * 514 + 9830 * 544) / 1024;
  record.fields[1] = {-16384, 0, 16 * 516, 0, 0};
  record.write(bytes);
  GlyphField field;
  CHECK_OK(GlyphField::open({bytes, record.size()}, field));
  const CrispOptions crisp;
  CHECK_EQ(Crossing(field, style_of(16, crisp)).left(), 255);
}

// And so is a hairline that leans, close to the pixel.
TEST(hairlines_are_found_near_the_pixel) {
  const CrispOptions crisp;
  const GlyphField field = stroke(11585, 11585, 731, 2);
  const Crossing drawing(field, style_of(16, crisp));
  CHECK_EQ(drawing.left(), 255);
  CHECK_EQ(drawing.right(), 0);
}

TEST(thresholds_end_at_half_a_px) {
  constexpr int16_t kThresholds[] = {512, 513, INT16_MAX};
  // 2 px wide: half a pixel from the centres of the outer ones to the edges.
  // Distances know places to 1/256 px.
  const GlyphField field = stroke(16384, 0, kMiddle_u, 128);
  for (const int16_t raw : kThresholds) {
    CrispOptions crisp;
    crisp.threshold_px = Q6_10::from_raw(raw);
    const TextStyle style = style_of(16, crisp);
    const Crossing even(field, style);
    CHECK(even.left() == 255 && even.right() == 255);
    const Crossing odd(field, style, 4);
    CHECK(odd.left() == 0 && odd.right() == 255);
    crisp.threshold_px = Q6_10::from_raw(static_cast<int16_t>(-raw));
    const Crossing bold(field, style);
    CHECK(bold.picture.at(6, 7) == 255 && bold.picture.at(9, 7) == 255);
    const Crossing shifted(field, style, 4);
    CHECK(shifted.picture.at(6, 7) == 0 && shifted.picture.at(9, 7) == 255);
  }
}

// Greys are the filter's, whatever the threshold, where no stroke would break.
TEST(thresholds_do_not_move_greys) {
  const GlyphField field = stroke(13623, -9102, 150, 250);
  const CrispOptions plain = {4, {}};
  const CrispOptions light = {4, Q6_10::from_raw(300)};
  int32_t greys = 0;
  for (int32_t shift = 0; shift < 1024; shift += 100) {
    const Crossing expected(field, style_of(16, plain), shift);
    const Crossing found(field, style_of(16, light), shift);
    for (int32_t i = 0; i < 16; ++i) {
      const uint8_t level = expected.picture.at(i, 7);
      CHECK_EQ(found.picture.at(i, 7), level);
      greys += level == 85 || level == 170 ? 1 : 0;
    }
  }
  CHECK(greys > 4);
}

// Levels of coverage change from 42 to 43, and so on.
TEST(levels_change_in_the_middle) {
  const CrispOptions crisp = {4, {}};
  const TextStyle style = style_of(16, crisp);
  const GlyphField field = stroke(16384, 0, kMiddle_u, 192);
  int32_t least = 255;
  int32_t greatest = 0;
  for (int32_t shift = 0; shift < 1024; shift += 2) {
    const Crossing drawing(field, style, shift);
    Q6_10 row[16];
    distance_row(field, style, {shift, 16 << 10}, 0, 7, {row, 16});
    for (int32_t x = 6; x < 8; ++x) {
      const int32_t coverage = kFilterText.coverage(row[x].raw);
      CHECK_EQ(drawing.picture.at(x, 7), (coverage + 42) / 85 * 85);
      least = coverage < least ? coverage : least;
      greatest = coverage > greatest ? coverage : greatest;
    }
  }
  CHECK(least == 0 && greatest == 255);
}

// Bold strokes reach farther than a sharp filter does.
TEST(bold_strokes_pass_the_box_of_the_filter) {
  FilterSpec spec;
  spec.outside_px = Q6_10::from_raw(-32);
  spec.inside_px = Q6_10::from_raw(32);
  const Filter sharp = make_filter(spec);
  CrispOptions crisp;
  crisp.threshold_px = Q6_10::from_raw(-512);
  GlyphField field = stroke(16384, 0, kMiddle_u, 128);
  field.ink.x0_u = kMiddle_u - 64;
  field.ink.x1_u = kMiddle_u + 64;
  for (int32_t shift = 0; shift < 1024; shift += 50) {
    TextStyle style;
    CHECK_OK(TextStyle::make(Q26_6::from_int(16), sharp, style));
    style.set_effect(crisp_effect(crisp));
    const Crossing drawing(field, style, shift);
    int32_t drawn = 0;
    for (int32_t x = 0; x < 16; ++x) {
      drawn += drawing.picture.at(x, 7) == 255 ? 1 : 0;
    }
    CHECK_EQ(drawn, shift == 0 ? 4 : 3);
  }
}

#endif
