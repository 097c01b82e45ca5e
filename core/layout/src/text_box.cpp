#include "inkcell/layout/text_box.hpp"

#include "box_lines.hpp"
#include "text/glyph_run.hpp"

namespace inkcell {

using detail::BoxDrawer;
using detail::BoxLines;
using detail::FacesDrawer;
using detail::kFarthest;
using detail::line_step;
using detail::LineCell;
using detail::LineCursor;
using detail::Setting;

namespace {

// Draws the glyphs of a line, or adds up their boxes, as the painter's drawer
// does.
__attribute__((noinline)) void draw_line(const BoxLines& lines,
                                         int32_t y_q6,
                                         const Painter& painter) noexcept {
  const Setting& setting = lines.setting();
  FacesDrawer drawer(painter, setting.face(), setting.options.fallback);
  LineCursor cursor = lines.cursor();
  drawer.begin({Q26_6::from_int(lines.box().rect.x0), Q26_6::from_raw(y_q6)},
               false);
  LineCell cell;
  while (cursor.next(cell)) {
    if (cell.has_ink) {
      do {
        drawer.draw(detail::positioned(cursor.pen(), lines.line(), cell));
      } while (cursor.next_glyph(cell));
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
    LineCell cell;
    while (cursor_.next(cell)) {
      const bool is_rtl = cell.level % 2 != 0;
      if (cell.end == line.end() && (!cell.is_added || line.length == 0)) {
        end_x_ = is_rtl ? cell.x : cell.x_end;
        has_end_ = true;
      }
      if (cell.is_mark() || (cell.is_added && cell.begin == line.end())) {
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

// The place of the caret nearest to a column.
__attribute__((noinline)) TextPlace nearest_place(const BoxLines& lines,
                                                  int32_t x) noexcept {
  const int32_t x_q6 = detail::clamp_to(x, kFarthest >> 6) * 64 + 32;
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

// How far ink may be from its baseline: by no more than the box of the font,
// and the line that other faces and effects may take. [px, Q6]
int32_t ink_reach(const TextBox& box) noexcept {
  const Face& face = box.options.face;
  const FontMetrics metrics = face.font->metrics();
  const int32_t up = metrics.y_max;
  const int32_t down = -metrics.y_min;
  const Q26_6 reach = to_px(*face.font, *face.style, up > down ? up : down);
  return detail::clamp_to(reach.raw + line_step(box), kFarthest);
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

// Draws the lines that meet the box and a window. Keeps little on the stack,
// which finding lines is deep on.
void draw_lines(const TextBox& box,
                const Text& text,
                const Span<const TextLine>& lines,
                const Rect& window,
                const Painter& painter) noexcept {
  BoxLines found(box, painter, text, lines);
  if (ink_bottom(box, box.rect.y1 * 64) < window.y0 * 64) {
    return;  // no line begins below the box
  }
  int32_t top = found.top();
  while (top < box.rect.y1 * 64 && ink_top(box, top) <= window.y1 * 64 &&
         found.next()) {
    const int32_t next = top + line_step(box);
    if (next > box.rect.y0 * 64 && ink_bottom(box, top) >= window.y0 * 64) {
      found.prepare();
      draw_line(found, top + baseline(box.options).raw, painter);
    }
    top = next;
  }
}

// False: there is nothing to draw with, or nowhere to.
bool can_draw(const TextBox& box, TextReport* report) noexcept {
  const bool is_made = box.options.face.font != nullptr && !is_empty(box.clip);
  INKCELL_ASSERT(is_made);  // was the constructor of a static box called?
  if (!is_made && report != nullptr) {
    report->note(Status::bad_argument);
  }
  return is_made;
}

}  // namespace

Status TextBox::lay_out(Text text,
                        const Painter& painter,
                        Span<TextLine> out,
                        Span<const TextLine>& lines) const noexcept {
  const Span<const TextLine> none;
  BoxLines found(*this, painter, text, none);
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

void TextBox::draw(Text text,
                   const Painter& painter,
                   Span<const TextLine> lines) const noexcept {
  Sink clipped = painter.sink();
  clipped.window = intersect(clipped.window, clip);
  if (can_draw(*this, painter.report()) && !is_empty(clipped.window)) {
    draw_lines(*this, text, lines, clipped.window, painter.with(clipped));
  }
}

Rect TextBox::box(Text text,
                  const Painter& painter,
                  Span<const TextLine> lines) const noexcept {
  BoxDrawer boxes(painter);
  if (can_draw(*this, painter.report())) {
    draw_lines(*this, text, lines, clip, painter.with(boxes));
  }
  return intersect(boxes.sum, clip);
}

TextSize TextBox::measure(Text text,
                          const Painter& painter,
                          Span<const TextLine> lines) const noexcept {
  BoxLines found(*this, painter, text, lines);
  TextSize size;
  int32_t width = 0;
  int32_t height = 0;
  while (found.next()) {
    ++size.lines;
    height = detail::clamp_to(height + line_step(*this), kFarthest);
    width = found.line().width > width ? found.line().width : width;
  }
  size.width = to_px(*options.face.font, *options.face.style, width);
  size.height = Q26_6::from_raw(height);
  return size;
}

TextPlace TextBox::hit(Text text,
                       const Painter& painter,
                       int32_t x,
                       int32_t y,
                       Span<const TextLine> lines) const noexcept {
  BoxLines found(*this, painter, text, lines);
  int32_t bottom = found.top();
  bool is_found = false;
  while (!is_found && found.next()) {
    bottom = detail::clamp_to(bottom + line_step(*this), kFarthest);
    is_found = y < bottom >> 6 || found.is_last();
  }
  if (!is_found) {
    return {};
  }
  found.prepare();
  return nearest_place(found, x);
}

Rect TextBox::caret(Text text,
                    const Painter& painter,
                    TextPlace place,
                    Span<const TextLine> lines) const noexcept {
  BoxLines found(*this, painter, text, lines);
  int32_t top = found.top();
  bool is_found = false;
  while (!is_found && found.next()) {
    const TextLine& line = found.line();
    is_found = place.offset < line.next || found.is_last() ||
               (place.is_line_end && place.offset == line.next);
    top += is_found ? 0 : line_step(*this);
    top = detail::clamp_to(top, kFarthest);
  }
  if (!is_found) {
    return {};
  }
  found.prepare();
  const int32_t column = caret_column(found, place.offset);
  return {column, top >> 6, column + 1, (top + line_step(*this)) >> 6};
}

}  // namespace inkcell
