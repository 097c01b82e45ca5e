#include "inkcell/layout/text_box.hpp"
#include "inkcell/painter.hpp"

#include "line_cursor.hpp"
#include "next_line.hpp"

namespace inkcell {

using detail::Cell;
using detail::LineCursor;

namespace {

// Lines and boxes lie within this. [px, Q6]
constexpr int32_t kFar = 1 << 28;

Q26_6 width_of(const TextBox& box) noexcept {
  return Q26_6::from_int(box.rect.x1 - box.rect.x0);
}

int32_t height_of(const TextBox& box) noexcept {
  return (box.rect.y1 - box.rect.y0) * 64;
}

int32_t line_step(const TextBox& box) noexcept {
  return detail::clamp_to(line_height(box.options).raw, kFar);
}

// With an ellipsis a box holds no more lines than it has room for.
size_t most_lines(const TextBox& box) noexcept {
  if (box.options.ellipsis == Ellipsis::none || !box.options.wraps) {
    return SIZE_MAX;
  }
  const int32_t height = line_step(box);
  const int32_t room = height_of(box);
  return height > 0 && room > height
             ? static_cast<uint32_t>(room) / static_cast<uint32_t>(height)
             : 1;
}

// The lines of a box, one after the other: those that are given, or found anew.
// What it is made from must outlive it.
class BoxLines {
 public:
  BoxLines(const TextBox& box,
           const Text& text,
           const Span<const TextLine>& given) noexcept
      : box_(box), text_(text), given_(given) {
    if (box.options.bidi() != nullptr) {
      box.options.bidi()->forget();
    }
    most_ = is_given() ? given.size : most_lines(box);
  }

  const TextBox& box() const noexcept { return box_; }
  const TextLine& line() const noexcept { return line_; }
  // Whether next() would find none.
  bool is_last() const noexcept { return line_.is_last || count_ == most_; }

  bool next() noexcept;

  // Where the first line begins, from the top of the screen. [px, Q6] Only
  // before next() was called.
  int32_t top() noexcept;

  // Of a line that is prepared.
  void prepare() const noexcept {
    static_cast<void>(detail::prepare(box_.options, text_, line_));
  }
  LineCursor cursor() const noexcept {
    LineCursor cursor(box_.options, text_, line_);
    cursor.align(width_of(box_));
    return cursor;
  }

 private:
  bool is_given() const noexcept { return given_.data != nullptr; }

  const TextBox& box_;
  const Text& text_;
  const Span<const TextLine>& given_;
  TextLine line_;
  size_t count_ = 0;
  size_t most_;
};

__attribute__((noinline)) bool BoxLines::next() noexcept {
  if (count_ == most_) {
    return false;
  }
  if (is_given()) {
    line_ = given_[count_++];
    return true;
  }
  if (!detail::find_next_line(box_.options, text_, width_of(box_), line_)) {
    return false;
  }
  ++count_;
  if (count_ == most_ && !line_.is_last) {
    detail::shorten_line(box_.options, text_, width_of(box_), line_);
  }
  return true;
}

// Where the first of so many lines begins.
__attribute__((noinline)) int32_t top_of(const TextBox& box,
                                         size_t count) noexcept {
  const int32_t top = box.rect.y0 * 64;
  const int32_t height = line_step(box);
  const int64_t lines = static_cast<int64_t>(count) * height;
  int32_t room =
      height_of(box) - (lines < kFar ? static_cast<int32_t>(lines) : kFar);
  if (box.vertical == VerticalAlign::bottom) {
    return top + room;
  }
  if (box.vertical == VerticalAlign::optical) {
    const Face& face = box.options.face;
    const int32_t rise = baseline(box.options).raw;
    const int32_t cap =
        to_px(*face.font, *face.style, face.font->metrics().cap_height).raw;
    // What is above capitals in the first line, and below the last baseline.
    room += (height - rise) - (rise - cap);
  }
  // Whole pixels, so that lines stay as sharp as at the top.
  return top + ((room / 2) & ~63);
}

__attribute__((noinline)) int32_t BoxLines::top() noexcept {
  if (box_.vertical == VerticalAlign::top) {
    return box_.rect.y0 * 64;
  }
  if (!is_given()) {
    while (next()) {
    }
    line_ = {};
  }
  const size_t count = is_given() ? given_.size : count_;
  count_ = 0;
  return top_of(box_, count);
}

__attribute__((noinline)) void draw_cell(const TextBox& box,
                                         const PositionedGlyph& glyph,
                                         int32_t y_q6,
                                         const Sink& sink,
                                         Workspace workspace) noexcept {
  Sink clipped = sink;
  clipped.window = intersect(sink.window, box.rect);
  const Point origin = {Q26_6::from_int(box.rect.x0), Q26_6::from_raw(y_q6)};
  inkcell::Painter(clipped, workspace)
      .glyphs(box.options.face, box.options.fallback, origin, {&glyph, 1});
}

__attribute__((noinline)) void draw_line(const BoxLines& lines,
                                         int32_t y_q6,
                                         const Sink& sink,
                                         const Workspace& workspace) noexcept {
  LineCursor cursor = lines.cursor();
  Cell cell;
  while (cursor.next(cell)) {
    if (cell.has_ink) {
      draw_cell(lines.box(),
                detail::positioned(cursor.pen(), lines.line(), cell), y_q6,
                sink, workspace);
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
__attribute__((noinline)) int32_t ink_reach(const TextBox& box) noexcept {
  const Face& face = box.options.face;
  const FontMetrics metrics = face.font->metrics();
  const int32_t up = metrics.y_max;
  const int32_t down = -metrics.y_min;
  const Q26_6 reach = to_px(*face.font, *face.style, up > down ? up : down);
  return detail::clamp_to(reach.raw + line_step(box), kFar);
}

}  // namespace

void TextBox::draw(Text text,
                   const Sink& sink,
                   Workspace workspace,
                   Span<const TextLine> lines) const noexcept {
  if (is_empty(intersect(sink.window, rect))) {
    return;
  }
  BoxLines found(*this, text, lines);
  int32_t y_q6 = found.top() + baseline(options).raw;
  const int32_t reach = ink_reach(*this);
  while (found.next() && y_q6 - reach <= sink.window.y1 * 64) {
    if (y_q6 + reach >= sink.window.y0 * 64) {
      found.prepare();
      draw_line(found, y_q6, sink, workspace);
    }
    y_q6 += line_step(*this);
  }
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
    // Of two that are as near, the one to the left.
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
