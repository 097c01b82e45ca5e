#include "inkcell/text_box.hpp"

#include "layout/line_cursor.hpp"
#include "layout/next_line.hpp"

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
class BoxLines {
 public:
  BoxLines(const TextBox& box, Text text, Span<const TextLine> given) noexcept
      : box_(box), text_(text), given_(given) {
    if (box.options.bidi() != nullptr) {
      box.options.bidi()->forget();
    }
    most_ = most_lines(box);
  }

  const TextLine& line() const noexcept { return line_; }
  // Whether next() would find none.
  bool is_last() const noexcept {
    return given_.data != nullptr ? count_ == given_.size
                                  : line_.is_last || count_ == most_;
  }

  bool next() noexcept {
    if (given_.data != nullptr) {
      if (count_ == given_.size) {
        return false;
      }
      line_ = given_[count_++];
      return true;
    }
    if (count_ == most_ ||
        !next_line(box_.options, text_, width_of(box_), line_)) {
      return false;
    }
    ++count_;
    if (count_ == most_ && !line_.is_last) {
      shorten(box_.options, text_, width_of(box_), line_);
    }
    return true;
  }

  // Prepares the line's paragraph.
  LineCursor cursor() const noexcept {
    const LayoutOptions& options = box_.options;
    if (options.order() != nullptr) {
      options.order()->prepare(*options.bidi(), text_, line_.paragraph,
                               options.direction);
    }
    return LineCursor(options, text_, line_, width_of(box_));
  }

 private:
  const TextBox& box_;
  Text text_;
  Span<const TextLine> given_;
  TextLine line_;
  size_t count_ = 0;
  size_t most_ = SIZE_MAX;
};

__attribute__((noinline)) size_t count_lines(
    const TextBox& box, Text text, Span<const TextLine> given) noexcept {
  if (given.data != nullptr) {
    return given.size;
  }
  const size_t most = most_lines(box);
  const int32_t room = detail::room_of(box.options, width_of(box));
  TextLine line;
  size_t count = 0;
  while (count != most &&
         detail::find_next_line(box.options, text, room, line)) {
    ++count;
  }
  return count;
}

// Where the first line begins, from the top of the screen. [px, Q6]
__attribute__((noinline)) int32_t top_of(const TextBox& box,
                                         Text text,
                                         Span<const TextLine> given) noexcept {
  const int32_t top = box.rect.y0 * 64;
  if (box.vertical == VerticalAlign::top) {
    return top;
  }
  const int32_t height = line_step(box);
  const auto count = static_cast<int64_t>(count_lines(box, text, given));
  const int64_t lines = count * height;
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

__attribute__((noinline)) void draw_line(const TextBox& box,
                                         const BoxLines& lines,
                                         Point origin,
                                         const Sink& sink,
                                         Workspace workspace) noexcept {
  const LayoutOptions& options = box.options;
  LineCursor cursor = lines.cursor();
  Cell cell;
  while (cursor.next(cell)) {
    if (cell.has_ink) {
      const PositionedGlyph glyph =
          detail::positioned(cursor.pen(), lines.line(), cell);
      inkcell::draw(options.face, options.fallback, {&glyph, 1}, origin, sink,
                    workspace);
    }
  }
}

// Carets of a line, one after the other: at the leading edge of each character,
// at an ellipsis, and behind the last character.
class Carets {
 public:
  explicit Carets(const BoxLines& lines) noexcept
      : cursor_(lines.cursor()), line_(lines.line()) {}

  // On the screen. [px]
  int32_t x_q6(const TextBox& box, int32_t x) const noexcept {
    return box.rect.x0 * 64 + cursor_.pen().to_px(x).raw;
  }

  bool next(uint32_t& offset, int32_t& x) noexcept {
    Cell cell;
    while (cursor_.next(cell)) {
      const bool is_rtl = cell.level % 2 != 0;
      if (cell.end == line_.end() && (!cell.is_added || line_.length == 0)) {
        end_x_ = is_rtl ? cell.x : cell.x_end;
        has_end_ = true;
      }
      if (cell.is_mark || (cell.is_added && cell.begin == line_.end())) {
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
    offset = line_.end();
    const bool is_rtl = line_.base_level % 2 != 0;
    x = has_end_ ? end_x_ : (is_rtl ? cursor_.left() : cursor_.right());
    return true;
  }

 private:
  LineCursor cursor_;
  const TextLine& line_;
  int32_t end_x_ = 0;
  bool has_end_ = false;
  bool is_done_ = false;
};

}  // namespace

Status TextBox::lay_out(Text text,
                        Span<TextLine> out,
                        Span<const TextLine>& lines) const noexcept {
  BoxLines found(*this, text, {});
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

// Lines from `top` on that meet the window. [px, Q6]
__attribute__((noinline)) void draw_lines(const TextBox& box,
                                          Text text,
                                          int32_t top,
                                          const Sink& sink,
                                          Workspace workspace,
                                          Span<const TextLine> given) noexcept {
  const int32_t height = line_step(box);
  Point origin = {Q26_6::from_int(box.rect.x0), baseline(box.options)};
  origin.y.raw += top;
  const int32_t reach = ink_reach(box);
  BoxLines lines(box, text, given);
  while (lines.next()) {
    if (origin.y.raw - reach > sink.window.y1 * 64) {
      break;
    }
    if (origin.y.raw + reach >= sink.window.y0 * 64) {
      draw_line(box, lines, origin, sink, workspace);
    }
    origin.y.raw += height;
  }
}

}  // namespace

void TextBox::draw(Text text,
                   const Sink& sink,
                   Workspace workspace,
                   Span<const TextLine> lines) const noexcept {
  Sink clipped = sink;
  clipped.window = intersect(sink.window, rect);
  if (!is_empty(clipped.window)) {
    draw_lines(*this, text, top_of(*this, text, lines), clipped, workspace,
               lines);
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
__attribute__((noinline)) TextPlace nearest_place(const TextBox& box,
                                                  const BoxLines& lines,
                                                  int32_t x) noexcept {
  const int32_t x_q6 = detail::clamp_to(x, kFar >> 6) * 64 + 32;
  const TextLine& line = lines.line();
  Carets carets(lines);
  TextPlace best;
  uint32_t offset = 0;
  int32_t caret_x = 0;
  int32_t least = INT32_MAX;
  while (carets.next(offset, caret_x)) {
    const int32_t way = carets.x_q6(box, caret_x) - x_q6;
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
__attribute__((noinline)) int32_t caret_column(const TextBox& box,
                                               const BoxLines& lines,
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
      column = carets.x_q6(box, x) >> 6;
    }
  }
  return column;
}

}  // namespace

TextPlace TextBox::hit(Text text,
                       int32_t x,
                       int32_t y,
                       Span<const TextLine> lines) const noexcept {
  int32_t bottom = top_of(*this, text, lines);
  BoxLines found(*this, text, lines);
  bool is_found = false;
  while (!is_found && found.next()) {
    bottom = detail::clamp_to(bottom + line_step(*this), kFar);
    is_found = y < bottom >> 6 || found.is_last();
  }
  return is_found ? nearest_place(*this, found, x) : TextPlace{};
}

Rect TextBox::caret(Text text,
                    TextPlace place,
                    Span<const TextLine> lines) const noexcept {
  int32_t top = top_of(*this, text, lines);
  BoxLines found(*this, text, lines);
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
  const int32_t column = caret_column(*this, found, place.offset);
  return {column, top >> 6, column + 1, (top + line_step(*this)) >> 6};
}

}  // namespace inkcell
