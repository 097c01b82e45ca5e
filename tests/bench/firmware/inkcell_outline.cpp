// Inkcell with a font of outlines, or a TrueType file, by area only. Ways:
//
//   upright, turned, leaning   by distance; by 15 degrees, and by 1/5
//   area, area_turned          by exact coverage
//   strips                     upright, decoded anew for each strip
//   stack, area_stack          the same without lent RAM
//
// All but those of the last line lend kWorkspace bytes.
#include "inkcell/painter.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "inkcell_strips.hpp"

using namespace inkcell;

namespace {

constexpr size_t kWorkspace = 2560;
alignas(4) uint8_t workspace[kWorkspace];

enum class Way { prepared, strips, stack };
Way way = Way::prepared;

constexpr Direction kTurn = {
    Fixed<int32_t, 30>::from_raw(1037154959),  // 15 degrees
    Fixed<int32_t, 30>::from_raw(277904834)};

bool make_style(Q26_6 size, const char* name) {
  using bench::equal;
  using bench::style;
  if (equal(name, "turned")) {
    style = Style(size, kFilterText, kTurn);
  } else if (equal(name, "leaning")) {
    const auto em = Q16_16::from_raw(size.raw << 10);
    const Matrix matrix = {em, {}, Q16_16::from_raw(em.raw / 5), em};
    style = Style(matrix, kFilterText);
  } else if (equal(name, "area") || equal(name, "area_stack")) {
    way = equal(name, "area") ? Way::prepared : Way::stack;
    style = Style(size, kFilterArea);
  } else if (equal(name, "area_turned")) {
    style = Style(size, kFilterArea, kTurn);
  } else {
    way = equal(name, "strips")  ? Way::strips
          : equal(name, "stack") ? Way::stack
                                 : Way::prepared;
    style = Style(size, kFilterText);
    return way != Way::prepared || equal(name, "upright");
  }
  return true;
}

}  // namespace

bool engine_set_size(uint32_t px, const char* name) {
  way = Way::prepared;
  return make_style(Q26_6::from_int(static_cast<int32_t>(px)), name);
}

engine_answer engine_prepare(uint32_t code_point) {
  uint16_t glyph = 0;
  PreparedGlyph prepared;
  if (bench::font.glyph_of(code_point, glyph) != Status::ok ||
      PreparedGlyph::make(bench::font, glyph, bench::style, {},
                          {workspace, kWorkspace}, prepared) != Status::ok) {
    return engine_lacks;
  }
  return bench::place(glyph, prepared.box());
}

void engine_draw(uint32_t code_point) {
  uint16_t glyph = 0;
  if (bench::font.glyph_of(code_point, glyph) != Status::ok) {
    return;
  }
  if (way != Way::prepared) {
    const Workspace ram =
        way == Way::strips ? Workspace{workspace, kWorkspace} : Workspace{};
    bench::draw_strips([glyph, &ram] {
      Painter(bench::sink, ram)
          .glyph(bench::font, bench::style, bench::origin, glyph);
    });
    return;
  }
  PreparedGlyph prepared;
  if (PreparedGlyph::make(bench::font, glyph, bench::style, bench::origin,
                          {workspace, kWorkspace}, prepared) == Status::ok) {
    bench::draw_strips([&prepared] { prepared.draw(bench::sink); });
  }
}

size_t engine_workspace() {
  return way == Way::stack ? 0 : kWorkspace;
}
