// Inkcell with a direct font, of fields or of samples. Ways: "upright", and
// "turned" by 15 degrees.
#include "inkcell_strips.hpp"

using namespace inkcell;

bool engine_set_size(uint32_t px, const char* way) {
  Direction direction;
  if (bench::equal(way, "turned")) {
    direction.cosine.raw = 1037154959;
    direction.sine.raw = 277904834;
  } else if (!bench::equal(way, "upright")) {
    return false;
  }
  return Brush::make(Q26_6::from_int(static_cast<int32_t>(px)), kFilterText,
                     direction, bench::brush) == Status::ok;
}

engine_answer engine_prepare(uint32_t code_point) {
  uint16_t glyph = 0;
  GlyphField field;
  if (bench::font.glyph_of(code_point, glyph) != Status::ok ||
      bench::font.field(glyph, field) != Status::ok) {
    return engine_lacks;
  }
  return bench::place(glyph, field);
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
