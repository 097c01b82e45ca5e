// Inkcell with a packed font. Ways:
//
//   packed     expands a glyph whole, once for all of its strips
//   retained   the same, but has expanded it before
//   rows       expands for each strip anew, a row of tiles at a time
#include "inkcell/packed.hpp"
#include "inkcell_strips.hpp"

using namespace inkcell;

namespace {

enum class Way { packed, retained, rows };

alignas(4) uint8_t workspace[32768];
Way way = Way::packed;
GlyphField retained;

// The whole glyph; also if it is one of those that are not packed.
Status expand_glyph(uint16_t glyph, GlyphField& out) {
  PackedGlyph packed;
  const Status status = PackedGlyph::open(bench::font, glyph, packed);
  if (status == Status::unsupported) {
    return bench::font.field(glyph, out);
  }
  INKCELL_TRY(status);
  if (packed.tiles_y == 0) {
    out = GlyphField{};
    return Status::ok;
  }
  return expand(packed, 0, packed.tiles_y, {workspace, sizeof workspace}, out);
}

void draw_rows(uint16_t glyph) {
  const Workspace rows = {workspace, bench::font.row_workspace_bytes()};
  bench::draw_strips([glyph, &rows] {
    draw_glyph(bench::font, glyph, bench::brush, bench::origin, bench::sink,
               rows);
  });
}

}  // namespace

bool engine_set_size(uint32_t px, const char* name) {
  if (bench::equal(name, "packed")) {
    way = Way::packed;
  } else if (bench::equal(name, "retained")) {
    way = Way::retained;
  } else if (bench::equal(name, "rows")) {
    way = Way::rows;
  } else {
    return false;
  }
  return bench::font.workspace_bytes() <= sizeof workspace &&
         Brush::make(Q26_6::from_int(static_cast<int32_t>(px)), kFilterText,
                     bench::brush) == Status::ok;
}

engine_answer engine_prepare(uint32_t code_point) {
  uint16_t glyph = 0;
  if (bench::font.glyph_of(code_point, glyph) != Status::ok ||
      expand_glyph(glyph, retained) != Status::ok) {
    return engine_lacks;
  }
  return bench::place(glyph, retained);
}

void engine_draw(uint32_t code_point) {
  uint16_t glyph = 0;
  if (bench::font.glyph_of(code_point, glyph) != Status::ok) {
    return;
  }
  if (way == Way::rows) {
    draw_rows(glyph);
    return;
  }
  GlyphField field = retained;
  if (way == Way::packed && expand_glyph(glyph, field) != Status::ok) {
    return;
  }
  bench::draw_strips([&field] {
    draw_field(field, bench::brush, bench::origin, bench::sink);
  });
}

size_t engine_workspace() {
  return way == Way::rows ? bench::font.row_workspace_bytes()
                          : bench::font.workspace_bytes();
}
