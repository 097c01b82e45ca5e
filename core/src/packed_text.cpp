// Drawing packed glyphs: expansion of what a window shows, and the renderer.
#include "inkcell/packed.hpp"
#include "inkcell/text.hpp"
#include "packed_rows.hpp"
#include "record.hpp"
#include "text_place.hpp"

namespace inkcell {
namespace {

using detail::place_near;
using detail::Placed;
using detail::UnitScale;

// Rows of tiles: begin <= row < end.
struct Rows {
  uint32_t begin;
  uint32_t end;
};

Rect box_of(const PackedGlyph& glyph,
            const Rows& rows,
            const Brush& brush,
            const Placed& placed) noexcept {
  return detail::box_of(glyph.grid(rows.begin, rows.end - rows.begin), brush,
                        placed);
}

bool is_within(const Rect& inner, const Rect& outer) noexcept {
  return inner.x0 >= outer.x0 && inner.y0 >= outer.y0 && inner.x1 <= outer.x1 &&
         inner.y1 <= outer.y1;
}

bool meets_window(const PackedGlyph& glyph,
                  uint32_t row,
                  const Brush& brush,
                  const Placed& placed,
                  const Rect& window) noexcept {
  return !is_empty(
      intersect(box_of(glyph, {row, row + 1}, brush, placed), window));
}

// None if the glyph is out of sight; else all, or without those at both ends
// that are. Not a part of its caller, which has little stack for drawing.
__attribute__((noinline)) Rows rows_in_window(const PackedGlyph& glyph,
                                              bool leaves_out,
                                              const Brush& brush,
                                              const Placed& placed,
                                              const Rect& window) noexcept {
  Rows rows = {0, glyph.tiles_y};
  const Rect box = box_of(glyph, rows, brush, placed);
  if (is_empty(intersect(box, window))) {
    return {0, 0};
  }
  if (!leaves_out || is_within(box, window)) {
    return rows;
  }
  while (rows.begin < rows.end &&
         !meets_window(glyph, rows.begin, brush, placed, window)) {
    ++rows.begin;
  }
  while (rows.begin < rows.end &&
         !meets_window(glyph, rows.end - 1, brush, placed, window)) {
    --rows.end;
  }
  return rows;
}

// Whether every pixel is drawn from the one row of tiles that holds its centre.
// Else a glyph is drawn from all of its rows or not at all: rows that make no
// sense must not show in some windows only.
bool goes_by_rows(const Brush& brush) noexcept {
  return brush.is_upright() && brush.painter() == nullptr;
}

// From the highest row of tiles to the lowest, so that pixels come from top to
// bottom, `at_once` rows at a time, or one by one if that does not work: what
// is left out must not depend on the window. A pixel's centre lies in one row
// only.
void draw_rows(const PackedGlyph& glyph,
               Rows rows,
               uint32_t at_once,
               const Brush& brush,
               const Placed& placed,
               const Sink& sink,
               Workspace workspace) noexcept {
  detail::SharedFields shared;
  while (rows.end > rows.begin) {
    const uint32_t left = rows.end - rows.begin;
    const uint32_t count = at_once < left ? at_once : left;
    GlyphField field;
    if (detail::expand_rows(glyph, rows.end - count, count, workspace, shared,
                            field) == Status::ok) {
      detail::draw_near(field, brush, placed, sink);
    } else if (count > 1 && goes_by_rows(brush)) {
      at_once = 1;
      continue;
    }
    rows.end -= count;
  }
}

void draw_placed(const Font& font,
                 uint16_t glyph,
                 const Brush& brush,
                 const Placed& placed,
                 const Sink& sink,
                 Workspace workspace) noexcept {
  if (GlyphField in_place;
      detail::read_field(font, glyph, in_place) == Status::ok) {
    detail::draw_near(in_place, brush, placed, sink);
    return;
  }
  PackedGlyph packed;
  if (detail::read_packed(font, glyph, packed) != Status::ok) {
    return;
  }
  const bool by_rows = goes_by_rows(brush);
  const Rows rows = rows_in_window(packed, by_rows, brush, placed, sink.window);
  const bool is_roomy = workspace.size >= font.workspace_bytes();
  const uint32_t at_once = by_rows && !is_roomy ? 1 : packed.tiles_y;
  draw_rows(packed, rows, at_once, brush, placed, sink, workspace);
}

}  // namespace

void draw(const Font& font,
          Span<const PositionedGlyph> glyphs,
          const Brush& brush,
          Point origin,
          const Sink& sink,
          Workspace workspace) noexcept {
  const UnitScale scale(font, brush);
  for (const PositionedGlyph& at : glyphs) {
    Placed placed;
    if (place_near(scale, brush, origin, at, placed)) {
      draw_placed(font, at.glyph, brush, placed, sink, workspace);
    }
  }
}

void draw_text(const Font& font,
               Text text,
               const Brush& brush,
               Point origin,
               const Sink& sink,
               Workspace workspace) noexcept {
  const UnitScale scale(font, brush);
  TextCursor cursor(font, text);
  PositionedGlyph at;
  while (cursor.next(at)) {
    Placed placed;
    if (place_near(scale, brush, origin, at, placed)) {
      draw_placed(font, at.glyph, brush, placed, sink, workspace);
    }
  }
}

void draw_glyph(const Font& font,
                uint16_t glyph,
                const Brush& brush,
                Point origin,
                const Sink& sink,
                Workspace workspace) noexcept {
  Placed placed;
  if (placed.set(origin)) {
    draw_placed(font, glyph, brush, placed, sink, workspace);
  }
}

}  // namespace inkcell
