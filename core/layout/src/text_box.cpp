#include "inkcell/layout/text_box.hpp"
#include "inkcell/painter.hpp"

#include "box_lines.hpp"

namespace inkcell {

using detail::BoxLines;
using detail::Cell;
using detail::kFar;
using detail::line_step;
using detail::LineCursor;

namespace {

// What becomes of the glyphs of a box: they are drawn, or their pixels added
// up.
struct Drawing {
  const Sink& sink;
  const Workspace& workspace;

  __attribute__((noinline)) void take(
      const TextBox& box,
      Point origin,
      const PositionedGlyph& glyph) const noexcept {
    Sink clipped = sink;
    clipped.window = intersect(clipped.window, box.clip);
    inkcell::Painter(clipped, workspace)
        .glyphs(box.options.face, box.options.fallback, origin, {&glyph, 1});
  }
};

struct Summing {
  Rect& sum;

  __attribute__((noinline)) void take(
      const TextBox& box,
      Point origin,
      const PositionedGlyph& glyph) const noexcept {
    const Rect pixels = inkcell::Painter().box(
        box.options.face, box.options.fallback, origin, {&glyph, 1});
    sum = bounding_box(sum, intersect(pixels, box.clip));
  }
};

template <typename Taker>
__attribute__((noinline)) void take_line(const BoxLines& lines,
                                         int32_t y_q6,
                                         const Taker& taker) noexcept {
  const TextBox& box = lines.box();
  const Point origin = {Q26_6::from_int(box.rect.x0), Q26_6::from_raw(y_q6)};
  LineCursor cursor = lines.cursor();
  Cell cell;
  while (cursor.next(cell)) {
    if (cell.has_ink) {
      taker.take(box, origin,
                 detail::positioned(cursor.pen(), lines.line(), cell));
    }
  }
}

// Carets of a line, one after the other: at the leading edge of each character,
// at an ellipsis, and behind the last character.
class Carets {
 public:
  explicit Carets(const BoxLines& lines) noexcept
      : lines_(lines), cursor_(lines.cursor()) {}

  // On the screen. [px]
  int32_t x_q6(int32_t x) const noexcept {
    return lines_.box().rect.x0 * 64 + cursor_.pen().to_px(x).raw;
  }

  bool next(uint32_t& offset, int32_t& x) noexcept {
    const TextLine& line = lines_.line();
    Cell cell;
    while (cursor_.next(cell)) {
      const bool is_rtl = cell.level % 2 != 0;
      if (cell.end == line.end() && (!cell.is_added || line.length == 0)) {
        end_x_ = is_rtl ? cell.x : cell.x_end;
        has_end_ = true;
      }
      if (cell.is_mark || (cell.is_added && cell.begin == line.end())) {
        continue;
      }
      offset = cell.begin;
      x = is_rtl ? cell.x_end : cell.x;
      return true;
    }
    if (is_done_) {
      return false;
    }
    is_done_ = true;
    offset = line.end();
    const bool is_rtl = line.base_level % 2 != 0;
    x = has_end_ ? end_x_ : (is_rtl ? cursor_.left() : cursor_.right());
    return true;
  }

 private:
  const BoxLines& lines_;
  LineCursor cursor_;
  int32_t end_x_ = 0;
  bool has_end_ = false;
  bool is_done_ = false;
};

}  // namespace

Status TextBox::lay_out(Text text,
                        Span<TextLine> out,
                        Span<const TextLine>& lines) const noexcept {
  const Span<const TextLine> none;
  BoxLines found(*this, text, none);
  size_t count = 0;
  while (found.next()) {
    if (count == out.size) {
      return Status::buffer_small;
    }
    out[count++] = found.line();
  }
  lines = {out.data, count};
  return Status::ok;
}

namespace {

// How far ink may be from its baseline: by no more than the box of the font,
// and the line that other faces and effects may take. [px, Q6]
int32_t ink_reach(const TextBox& box) noexcept {
  const Face& face = box.options.face;
  const FontMetrics metrics = face.font->metrics();
  const int32_t up = metrics.y_max;
  const int32_t down = -metrics.y_min;
  const Q26_6 reach = to_px(*face.font, *face.style, up > down ? up : down);
  return detail::clamp_to(reach.raw + line_step(box), kFar);
}

// The rows that ink of a line may have, whose top is given. [px, Q6]
__attribute__((noinline)) int32_t ink_top(const TextBox& box,
                                          int32_t top) noexcept {
  return top + baseline(box.options).raw - ink_reach(box);
}
__attribute__((noinline)) int32_t ink_bottom(const TextBox& box,
                                             int32_t top) noexcept {
  return top + baseline(box.options).raw + ink_reach(box);
}

// Takes the glyphs of lines that meet the box and the window. Keeps little on
// the stack, which finding lines is deep on.
template <typename Taker>
__attribute__((always_inline)) inline void take_lines(
    const TextBox& box,
    const Text& text,
    const Span<const TextLine>& lines,
    const Rect& window,
    const Taker& taker) noexcept {
  BoxLines found(box, text, lines);
  int32_t top = found.top();
  while (top < box.rect.y1 * 64 && ink_top(box, top) <= window.y1 * 64 &&
         found.next()) {
    const int32_t next = top + line_step(box);
    if (next > box.rect.y0 * 64 && ink_bottom(box, top) >= window.y0 * 64) {
      found.prepare();
      take_line(found, top + baseline(box.options).raw, taker);
    }
    top = next;
  }
}

void draw_lines(const TextBox& box,
                Text text,
                const Sink& sink,
                Workspace workspace,
                Span<const TextLine> lines) noexcept {
  if (!is_empty(intersect(sink.window, box.clip))) {
    take_lines(box, text, lines, sink.window, Drawing{sink, workspace});
  }
}

// With the style that a sink of few levels draws the first face with.
__attribute__((noinline)) void draw_adapted(const TextBox& box,
                                            Text text,
                                            const Sink& sink,
                                            Workspace workspace) noexcept {
  Style room = *box.options.face.style;
  TextBox own = box;
  own.options.face.style = &sink.adapt(*box.options.face.style, false, room);
  draw_lines(own, text, sink, workspace, {});
}

}  // namespace

void TextBox::draw(Text text,
                   const Sink& sink,
                   Workspace workspace,
                   Span<const TextLine> lines) const noexcept {
  if (sink.adapt != nullptr && lines.data == nullptr &&
      options.face.style->is_fit_open()) {
    draw_adapted(*this, text, sink, workspace);
  } else {
    draw_lines(*this, text, sink, workspace, lines);
  }
}

Rect TextBox::box(Text text, Span<const TextLine> lines) const noexcept {
  Rect sum;
  take_lines(*this, text, lines, clip, Summing{sum});
  return sum;
}

TextSize TextBox::measure(Text text,
                          Span<const TextLine> lines) const noexcept {
  BoxLines found(*this, text, lines);
  TextSize size;
  int32_t width = 0;
  int32_t height = 0;
  while (found.next()) {
    ++size.lines;
    height = detail::clamp_to(height + line_step(*this), kFar);
    width = found.line().width > width ? found.line().width : width;
  }
  size.width = to_px(*options.face.font, *options.face.style, width);
  size.height = Q26_6::from_raw(height);
  return size;
}

namespace {

// The place of the caret nearest to a column.
__attribute__((noinline)) TextPlace nearest_place(const BoxLines& lines,
                                                  int32_t x) noexcept {
  const int32_t x_q6 = detail::clamp_to(x, kFar >> 6) * 64 + 32;
  const TextLine& line = lines.line();
  Carets carets(lines);
  TextPlace best;
  uint32_t offset = 0;
  int32_t caret_x = 0;
  int32_t least = INT32_MAX;
  while (carets.next(offset, caret_x)) {
    const int32_t way = carets.x_q6(caret_x) - x_q6;
    // Where two are as near, the one to the left.
    const int32_t rank = way < 0 ? -2 * way : 2 * way + 1;
    if (rank < least) {
      least = rank;
      best.offset = offset;
      best.is_line_end = offset == line.next && !line.is_last;
    }
  }
  return best;
}

// The column of the last caret that is not behind a place; of the leftmost one
// if all are.
__attribute__((noinline)) int32_t caret_column(const BoxLines& lines,
                                               size_t place) noexcept {
  Carets carets(lines);
  uint32_t offset = 0;
  int32_t x = 0;
  int64_t nearest = -2;
  int32_t column = 0;
  while (carets.next(offset, x)) {
    const int64_t rank = offset <= place ? int64_t{offset} : -1;
    if (rank > nearest) {
      nearest = rank;
      column = carets.x_q6(x) >> 6;
    }
  }
  return column;
}

}  // namespace

TextPlace TextBox::hit(Text text,
                       int32_t x,
                       int32_t y,
                       Span<const TextLine> lines) const noexcept {
  BoxLines found(*this, text, lines);
  int32_t bottom = found.top();
  bool is_found = false;
  while (!is_found && found.next()) {
    bottom = detail::clamp_to(bottom + line_step(*this), kFar);
    is_found = y < bottom >> 6 || found.is_last();
  }
  if (!is_found) {
    return {};
  }
  found.prepare();
  return nearest_place(found, x);
}

Rect TextBox::caret(Text text,
                    TextPlace place,
                    Span<const TextLine> lines) const noexcept {
  BoxLines found(*this, text, lines);
  int32_t top = found.top();
  bool is_found = false;
  while (!is_found && found.next()) {
    const TextLine& line = found.line();
    is_found = place.offset < line.next || found.is_last() ||
               (place.is_line_end && place.offset == line.next);
    top += is_found ? 0 : line_step(*this);
    top = detail::clamp_to(top, kFar);
  }
  if (!is_found) {
    return {};
  }
  found.prepare();
  const int32_t column = caret_column(found, place.offset);
  return {column, top >> 6, column + 1, (top + line_step(*this)) >> 6};
}

}  // namespace inkcell
