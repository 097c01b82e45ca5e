// Inkcell with a direct font, of fields or of samples. Way: "upright"; or in a
// program of its own (INKCELL_BENCH_TURNED) "turned", by 15 degrees, and
// "in_rows", upright at every size in the order of rows.
#include "inkcell/row_map.hpp"
#include "inkcell_strips.hpp"

using namespace inkcell;

namespace {

bool set_upright(Q26_6 size) {
  return Brush::make(size, kFilterText, bench::brush) == Status::ok;
}

#if INKCELL_BENCH_TURNED

// Fitted glyphs are drawn in rows. This moves nothing: the one knot, a quarter
// of an em above the baseline, stays where it is.
void keep_rows(const GlyphField&,
               const Brush& brush,
               const void*,
               FinePoint&,
               RowMap& rows) {
  const int32_t height_q10 = brush.size().raw * 4;
  rows.add(height_q10, height_q10);
}

#endif

}  // namespace

bool engine_set_size(uint32_t px, const char* way) {
  const Q26_6 size = Q26_6::from_int(static_cast<int32_t>(px));
#if INKCELL_BENCH_TURNED
  if (bench::equal(way, "turned")) {
    Direction direction;
    direction.cosine.raw = 1037154959;
    direction.sine.raw = 277904834;
    return Brush::make(size, kFilterText, direction, bench::brush) ==
           Status::ok;
  }
  if (bench::equal(way, "leaning")) {
    const auto em = Q16_16::from_int(static_cast<int32_t>(px));
    const Matrix matrix = {em, {}, Q16_16::from_raw(em.raw / 5), em};
    return Brush::make(matrix, kFilterText, bench::brush) == Status::ok;
  }
  const bool is_made = set_upright(size);
  bench::brush.set_fitter(keep_rows, nullptr);
  return is_made && bench::equal(way, "in_rows");
#else
  return bench::equal(way, "upright") && set_upright(size);
#endif
}

engine_answer engine_prepare(uint32_t code_point) {
  return bench::place_direct(code_point);
}

void engine_draw(uint32_t code_point) {
  uint16_t glyph = 0;
  if (bench::font.glyph_of(code_point, glyph) != Status::ok) {
    return;
  }
  bench::draw_strips([glyph] {
    draw_glyph(bench::font, glyph, bench::brush, bench::origin, bench::sink);
  });
}

size_t engine_workspace() {
  return 0;
}
