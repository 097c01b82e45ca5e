// Inkcell with a font of fields. Way: "upright"; or in a
// program of its own (INKCELL_BENCH_TURNED) "turned", by 15 degrees, and
// "leaning", by 1/5.
#include "inkcell/painter.hpp"
#include "inkcell_strips.hpp"

using namespace inkcell;

bool engine_set_size(uint32_t px, const char* way) {
  const Q26_6 size = Q26_6::from_int(static_cast<int32_t>(px));
#if INKCELL_BENCH_TURNED
  if (bench::equal(way, "turned")) {
    Direction direction;
    direction.cosine.raw = 1037154959;
    direction.sine.raw = 277904834;
    bench::style = Style(size, kFilterText, direction);
    return true;
  }
  if (bench::equal(way, "leaning")) {
    const auto em = Q16_16::from_int(static_cast<int32_t>(px));
    const Matrix matrix = {em, {}, Q16_16::from_raw(em.raw / 5), em};
    bench::style = Style(matrix, kFilterText);
    return true;
  }
  return false;
#else
  bench::style = Style(size, kFilterText);
  return bench::equal(way, "upright");
#endif
}

engine_answer engine_prepare(uint32_t code_point) {
  return bench::place_glyph(code_point);
}

void engine_draw(uint32_t code_point) {
  uint16_t glyph = 0;
  if (bench::font.glyph_of(code_point, glyph) != Status::ok) {
    return;
  }
  bench::draw_strips([glyph] {
    Painter(bench::sink).glyph(bench::font, bench::style, bench::origin, glyph);
  });
}

size_t engine_workspace() {
  return 0;
}
