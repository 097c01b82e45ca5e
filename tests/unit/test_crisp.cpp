// Crisp text: two and four levels, and strokes that stay whole.
#include "check.hpp"
#include "field_record.hpp"
#include "inkcell/crisp.hpp"
#include "picture.hpp"

#if INKCELL_FIELD_CELLS

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

Brush brush_of(int32_t px, const CrispStyle& style) {
  Brush brush;
  CHECK_OK(Brush::make(Q26_6::from_int(px), kFilterText, brush));
  brush.set_painter(paint_crisp, &style, kCrispReach);
  return brush;
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
    const CrispStyle style = {levels, {}};
    const Brush brush = brush_of(12, style);
    for (const auto& normal : kNormals) {
      for (int32_t width_u = 17; width_u <= 85; width_u += 17) {
        for (int32_t shift = 0; shift < 85; shift += 9) {
          const int32_t middle_u = (normal[0] + normal[1]) * 512 / 16384;
          const GlyphField field =
              stroke(normal[0], normal[1], middle_u + shift, width_u);
          Drawing drawing;
          draw_field(field, brush, {0, 12 << 10}, drawing.sink());
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
    CrispStyle style;
    style.threshold_px.raw = static_cast<int16_t>(threshold);
    const Brush brush = brush_of(12, style);
    for (int32_t shift = 0; shift < 85; shift += 5) {
      const GlyphField field = stroke(16069, 3196, 500 + shift, 250);
      Drawing drawing;
      const FinePoint origin(0, 12 << 10);
      draw_field(field, brush, origin, drawing.sink());
      for (int32_t y = 0; y < kSide; ++y) {
        Q6_10 row[kSide];
        distance_row(field, brush, origin, 0, y, {row, kSide});
        for (int32_t x = 0; x < kSide; ++x) {
          CHECK_EQ(drawing.at(x, y), row[x].raw >= threshold ? 255 : 0);
        }
      }
    }
  }
}

TEST(four_levels_are_the_nearest) {
  const CrispStyle style = {4, {}};
  const Brush brush = brush_of(12, style);
  const GlyphField field = stroke(13623, -9102, 150, 250);
  Drawing drawing;
  const FinePoint origin(0, 12 << 10);
  draw_field(field, brush, origin, drawing.sink());
  int32_t greys = 0;
  for (int32_t y = 0; y < kSide; ++y) {
    Q6_10 row[kSide];
    distance_row(field, brush, origin, 0, y, {row, kSide});
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
  const CrispStyle style;
  const Brush brush = brush_of(16, style);
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
    draw_field(field, brush, {shift, 16 << 10}, drawing.sink());
    for (int32_t y = 0; y < 16; ++y) {
      int32_t drawn = 0;
      for (int32_t x = 0; x < 16; ++x) {
        drawn += drawing.at(x, y) != 0 ? 1 : 0;
      }
      CHECK_EQ(drawn, y >= 8 ? 1 : 0);
    }
  }
}

#endif
