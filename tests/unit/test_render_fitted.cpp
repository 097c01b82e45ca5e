// Fitted glyphs of samples: each row is that of the height that the map says.
#include "check.hpp"
#include "inkcell/render.hpp"
#include "inkcell/row_map.hpp"
#include "painter_canvas.hpp"
#include "painter_glyph.hpp"

using namespace inkcell;

namespace {

using painter::kSide;

// As far down and up as a map goes.
void stretch(uint16_t, const Brush&, const void*, FinePoint&, RowMap& rows) {
  CHECK(rows.add(0, -1000));
  CHECK(rows.add(8 << 10, (8 << 10) + 1000));
}

void shift(
    uint16_t, const Brush&, const void* shift_q10, FinePoint&, RowMap& rows) {
  CHECK(rows.add(0, *static_cast<const int32_t*>(shift_q10)));
}

// A fitted glyph against the rows of one that is not, each moved by the map.
void check_rows(const GlyphField& field,
                int32_t px,
                const FinePoint& origin,
                Fitter fitter,
                const void* options) {
  Brush plain;
  CHECK_OK(Brush::make(Q26_6::from_int(px), kFilterText, plain));
  RowMap map;
  FinePoint moved = origin;
  fitter(field.glyph, plain, options, moved, map);
  Brush brush = plain;
  brush.set_fitter(fitter, options);
  painter::Canvas canvas({0, 0, kSide, kSide});
  draw_field(field, brush, origin, canvas.sink());
  int32_t drawn = 0;
  for (int32_t y = 0; y < kSide; ++y) {
    const auto height = static_cast<int32_t>(origin.y_q10) - y * 1024 - 512;
    const int32_t way = map.glyph_height_q10(height) - height;
    Q6_10 row[kSide];
    distance_row(field, plain, {origin.x_q10, origin.y_q10 + way}, 0, y,
                 {row, kSide});
    for (int32_t x = 0; x < kSide; ++x) {
      const uint8_t found = painter::picture[y * kSide + x];
      CHECK_EQ(found, kFilterText.coverage(row[x].raw));
      drawn += found != 0 ? 1 : 0;
    }
  }
  CHECK(drawn > kSide);
}

}  // namespace

// From 48 px on glyphs that are not fitted are drawn cell by cell.
TEST(large_fitted_rows_are_where_the_map_says) {
  const GlyphField field = painter::field_of(font_builder::ring);
  constexpr int32_t kSizes[] = {47, 48, 50};
  for (const int32_t px : kSizes) {
    check_rows(field, px, {512, 38 * 1024}, stretch, nullptr);
  }
}

// Up to 1 px beyond where the ink is without the map.
TEST(rows_that_are_shifted_are_all_drawn) {
  GlyphField field = painter::field_of(font_builder::bar);
  field.ink.x0_u = 200;
  field.ink.x1_u = 440;
  field.ink.y0_u = 0;
  field.ink.y1_u = 640;
  constexpr int32_t kShifts[] = {-1000, 1000};
  for (const int32_t shift_q10 : kShifts) {
    for (int32_t y = 0; y < 1024; y += 100) {
      check_rows(field, 20, {2000, 25 * 1024 + y}, shift, &shift_q10);
    }
  }
}
