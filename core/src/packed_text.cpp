// Drawing packed glyphs: expansion of what a window shows, and the renderer.
#include "inkcell/packed.hpp"
#include "inkcell/text.hpp"
#include "text_place.hpp"

namespace inkcell {
namespace {

using detail::place;
using detail::UnitScale;

// Rows of tiles: begin <= row < end.
struct Rows {
  uint32_t begin;
  uint32_t end;
};

bool meets_window(const PackedGlyph& glyph,
                  const Rows& rows,
                  const Brush& brush,
                  const FinePoint& origin,
                  const Sink& sink) noexcept {
  const GlyphField grid = glyph.grid(rows.begin, rows.end - rows.begin);
  return !is_empty(intersect(field_box(grid, brush, origin), sink.window));
}

// Whether every pixel is drawn from the one row of tiles that holds its centre.
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
               const FinePoint& origin,
               const Sink& sink,
               Workspace workspace) noexcept {
  while (rows.end > rows.begin) {
    const uint32_t left = rows.end - rows.begin;
    const uint32_t count = at_once < left ? at_once : left;
    GlyphField field;
    if (expand(glyph, rows.end - count, count, workspace, field) ==
        Status::ok) {
      draw_field(field, brush, origin, sink);
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
                 const FinePoint& origin,
                 const Sink& sink,
                 Workspace workspace) noexcept {
  GlyphField in_place;
  if (font.field(glyph, in_place) == Status::ok) {
    draw_field(in_place, brush, origin, sink);
    return;
  }
  PackedGlyph packed;
  if (PackedGlyph::open(font, glyph, packed) != Status::ok) {
    return;
  }
  Rows rows = {0, packed.tiles_y};
  if (!meets_window(packed, rows, brush, origin, sink)) {
    return;
  }
  uint32_t at_once = packed.tiles_y;
  const bool is_roomy = workspace.size >= font.workspace_bytes();
  // Where some rows of tiles fit, all do, or each can be drawn alone.
  if (brush.painter() == nullptr && (is_roomy || brush.is_upright())) {
    while (rows.begin < rows.end &&
           !meets_window(packed, {rows.begin, rows.begin + 1}, brush, origin,
                         sink)) {
      ++rows.begin;
    }
    while (
        rows.begin < rows.end &&
        !meets_window(packed, {rows.end - 1, rows.end}, brush, origin, sink)) {
      --rows.end;
    }
    if (!is_roomy) {
      at_once = 1;
    }
  }
  draw_rows(packed, rows, at_once, brush, origin, sink, workspace);
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
    draw_placed(font, at.glyph, brush, place(scale, brush, origin, at), sink,
                workspace);
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
    draw_placed(font, at.glyph, brush, place(scale, brush, origin, at), sink,
                workspace);
  }
}

void draw_glyph(const Font& font,
                uint16_t glyph,
                const Brush& brush,
                Point origin,
                const Sink& sink,
                Workspace workspace) noexcept {
  draw_placed(font, glyph, brush, origin, sink, workspace);
}

}  // namespace inkcell
