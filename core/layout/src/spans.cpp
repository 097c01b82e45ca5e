#include "inkcell/layout/spans.hpp"

#include "box_lines.hpp"
#include "text/glyph_run.hpp"

namespace inkcell {

using detail::BoxLines;

namespace {

// What a span is drawn with, and where its lines lie from a baseline. [px]
struct SpanLook {
  const TextSpan& span;
  const Painter& painter;
  Face face;
  int32_t left;  // of the box
  int32_t thick;
  int32_t under;    // down
  int32_t through;  // up, to its upper edge
  Rect* sum;        // of boxes; null: it is drawn

  SpanLook(const TextBox& box,
           const TextSpan& what,
           const Painter& with,
           Rect* to) noexcept
      : span(what),
        painter(with),
        face(box.options.face),
        left(box.rect.x0),
        sum(to) {
    const Q26_6 size = face.style->size();
    thick = size.raw < 2 * 14 * 64 ? 1 : (size.raw / 14 + 32) >> 6;
    under = 1 + (size.raw / 16 >> 6);
    const int32_t x_height = face.font->metrics().x_height;
    through = ((to_px(*face.font, *face.style, x_height).raw + 64) >> 7) +
              (thick + 1) / 2;
    face.style = span.style == nullptr ? face.style : span.style;
  }

  bool holds(uint32_t offset) const noexcept {
    return offset >= span.begin && offset < span.end;
  }

  // Both lines of columns [x0, x1) at a baseline.
  __attribute__((noinline)) void draw_marks(int32_t x0,
                                            int32_t x1,
                                            int32_t baseline) const noexcept {
    if ((span.lines & TextSpan::kUnderline) != 0) {
      draw_mark(x0, x1, baseline + under);
    }
    if ((span.lines & TextSpan::kStrikeThrough) != 0) {
      draw_mark(x0, x1, baseline - through);
    }
  }

 private:
  void draw_mark(int32_t x0, int32_t x1, int32_t y0) const noexcept {
    const Rect rect = {left + x0, y0, left + x1, y0 + thick};
    if (sum != nullptr) {
      *sum = bounding_box(*sum, rect);
      return;
    }
    const Sink& sink = painter.sink();
    const Rect seen = intersect(rect, sink.window);
    for (int32_t y = seen.y0; y < seen.y1 && seen.x0 < seen.x1; ++y) {
      sink.solid(sink.context, seen.x0, y, seen.x1 - seen.x0);
    }
  }
};

// The column of a place, from the left end of a box. [px]
__attribute__((noinline)) int32_t column_of(const detail::Pen& pen,
                                            int32_t x,
                                            int32_t round_q6) noexcept {
  return (pen.to_px(x).raw + round_q6) >> 6;
}

// Not inline, for its stack.
__attribute__((noinline)) void draw_cell(const detail::LineCursor& cursor,
                                         const TextLine& line,
                                         detail::LineCell& cell,
                                         detail::FacesDrawer& drawer) noexcept {
  for (bool has_glyph = cell.has_ink; has_glyph;
       has_glyph = cursor.next_glyph(cell)) {
    drawer.draw(detail::positioned(cursor.pen(), line, cell));
  }
}

// The part of a line that a span holds. What it holds may stand in several
// places of a line of mixed directions.
__attribute__((noinline)) void draw_line(const BoxLines& lines,
                                         const SpanLook& look,
                                         Q26_6 baseline) noexcept {
  detail::FacesDrawer drawer(look.painter, look.face,
                             lines.box().options.fallback);
  detail::LineCursor cursor = lines.cursor();
  drawer.begin({Q26_6::from_int(look.left), baseline}, false);
  detail::LineCell cell;
  bool was_held = false;
  int32_t x0 = 0;
  int32_t x1 = 0;
  bool goes_on = true;
  while (goes_on) {
    goes_on = cursor.next(cell);
    const bool is_held = goes_on && look.holds(cell.begin);
    if (was_held && !is_held) {
      look.draw_marks(x0, x1, (baseline.raw + 32) >> 6);
    }
    if (is_held) {
      x0 = was_held ? x0 : column_of(cursor.pen(), cell.x, 0);
      x1 = column_of(cursor.pen(), cell.x_end, 63);
      draw_cell(cursor, lines.line(), cell, drawer);
    }
    was_held = is_held;
  }
}

void draw_spans_of(const TextBox& box,
                   const Text& text,
                   const Span<const TextLine>& lines,
                   const SpanLook& look) noexcept {
  BoxLines found(box, look.painter, text, lines);
  int32_t top = found.top();
  while (top < box.rect.y1 * 64 && found.next()) {
    const TextLine& line = found.line();
    const int32_t next = top + detail::line_step(box);
    if (next > box.rect.y0 * 64 && line.begin < look.span.end &&
        line.next > look.span.begin) {
      found.prepare();
      draw_line(found, look, Q26_6::from_raw(top + baseline(box.options).raw));
    }
    top = next;
  }
}

}  // namespace

void draw_span(const TextBox& box,
               Text text,
               const TextSpan& span,
               const Painter& painter,
               Span<const TextLine> lines) noexcept {
  INKCELL_ASSERT(box.options.face.font != nullptr);
  Sink clipped = painter.sink();
  clipped.window = intersect(clipped.window, box.clip);
  if (!is_empty(clipped.window)) {
    const Painter inside = painter.with(clipped);
    draw_spans_of(box, text, lines, {box, span, inside, nullptr});
  }
}

Rect span_box(const TextBox& box,
              Text text,
              const TextSpan& span,
              const Painter& painter,
              Span<const TextLine> lines) noexcept {
  INKCELL_ASSERT(box.options.face.font != nullptr);
  detail::BoxDrawer boxes(painter);
  const Painter measuring = painter.with(boxes);
  Rect marks;
  draw_spans_of(box, text, lines, {box, span, measuring, &marks});
  return intersect(bounding_box(boxes.sum, marks), box.clip);
}

}  // namespace inkcell
