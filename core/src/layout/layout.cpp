// Over 400 lines: lines are found and shortened by the same walk.
#include "inkcell/layout.hpp"

#include "layout/line_cursor.hpp"
#include "layout/line_walk.hpp"
#include "layout/next_line.hpp"

namespace inkcell {

using detail::Break;
using detail::Cell;
using detail::LineClass;
using detail::LineCursor;
using detail::LineState;
using detail::LineWalk;
using detail::Pen;

namespace {

// Spaces that do not count where a line ends.
bool hangs(uint32_t code_point, LineClass line_class) noexcept {
  return code_point == ' ' ||
         (code_point != '\t' && line_class == LineClass::ba &&
          detail::shown_as(code_point) == detail::Shown::space);
}

// What a line shows up to a place.
struct Place {
  uint32_t end = 0;   // of what shows something
  int32_t width = 0;  // [units of the pen]
  uint16_t gaps = 0;
  bool has_hyphen = false;
};

// Goes along a text until there is no more room.
class LineFinder {
 public:
  LineFinder(const LayoutOptions& options,
             Text text,
             const TextLine& line,
             int32_t room) noexcept
      : walk_(options, text, line),
        begin_(line.begin),
        room_(room),
        cluster_begin_(line.begin) {
    here_.end = begin_;
  }

  void find(TextLine& line) noexcept;

 private:
  bool take(TextLine& line) noexcept;
  bool take_visible(uint32_t code_point,
                    const Cell& cell,
                    TextLine& line) noexcept;
  void end_line(const Place& place, uint32_t next, TextLine& line) noexcept;
  void keep_place(uint32_t at) noexcept;
  bool is_full(const Cell& cell) const noexcept;
  void end_paragraph(uint32_t code_point, TextLine& line) noexcept;

  LineWalk walk_;
  LineState state_;
  uint32_t begin_;
  int32_t room_;
  uint32_t cluster_begin_;
  Place here_;            // up to the character that was read last
  Place best_;            // where a line may end,
  uint32_t next_ = 0;     // and what follows it then; 0: there is none yet
  Place before_cluster_;  // a character and its marks
  bool is_after_hyphen_ = false;
  uint16_t pending_gaps_ = 0;  // that count if something follows them
};

void LineFinder::keep_place(uint32_t at) noexcept {
  int32_t width = here_.width;
  if (is_after_hyphen_) {
    width += walk_.pen().hyphen().width;
    if (width > room_) {
      return;
    }
  }
  best_ = here_;
  best_.width = width;
  best_.has_hyphen = is_after_hyphen_;
  next_ = at;
}

// A line holds a character with its marks, even if there is no room.
bool LineFinder::is_full(const Cell& cell) const noexcept {
  return cell.end - begin_ > kMaxLineBytes ||
         (cluster_begin_ != begin_ && cell.x_end > room_);
}

void LineFinder::end_line(const Place& place,
                          uint32_t next,
                          TextLine& line) noexcept {
  line.next = next;
  line.length = static_cast<uint16_t>(place.end - begin_);
  line.gaps = place.gaps;
  line.has_hyphen = place.has_hyphen;
  line.width = walk_.pen().to_units(place.width);
}

void LineFinder::end_paragraph(uint32_t code_point, TextLine& line) noexcept {
  if (code_point == '\r' && !walk_.at_end() && walk_.rest().data[0] == '\n') {
    Cell cell;
    static_cast<void>(walk_.take(cell));
  }
  end_line(here_, walk_.offset(), line);
  line.ends_paragraph = true;
}

// False: the line is full.
bool LineFinder::take_visible(uint32_t code_point,
                              const Cell& cell,
                              TextLine& line) noexcept {
  if (!cell.is_mark || cell.begin != here_.end) {
    cluster_begin_ = cell.begin;
    before_cluster_ = here_;
  }
  if (is_full(cell)) {
    if (next_ != 0) {
      end_line(best_, next_, line);
    } else {
      end_line(before_cluster_, cluster_begin_, line);
    }
    return false;
  }
  here_.gaps = static_cast<uint16_t>(here_.gaps + pending_gaps_);
  pending_gaps_ = detail::is_gap(code_point) ? 1 : 0;
  here_.end = cell.end;
  here_.width = cell.x_end;
  return true;
}

// One character; false: the line is at its end.
bool LineFinder::take(TextLine& line) noexcept {
  if (walk_.at_end()) {
    end_paragraph(0, line);
    line.is_last = true;
    return false;
  }
  Cell cell;
  const uint32_t code_point = walk_.take(cell);
  const LineClass line_class = detail::line_class(code_point);
  const Break place = state_.step(line_class, walk_.rest());
  if (detail::ends_line(line_class)) {
    end_paragraph(code_point, line);
    return false;
  }
  if (place == Break::allowed && here_.end != begin_) {
    keep_place(cell.begin);
  }
  is_after_hyphen_ =
      code_point == 0xad && cell.begin == here_.end && walk_.pen().has_begun();
  walk_.put(code_point, cell);
  // What has no width goes with spaces before it.
  const bool is_behind_spaces =
      !cell.has_ink && cell.x_end == cell.x && cell.begin != here_.end;
  if (is_behind_spaces || hangs(code_point, line_class)) {
    pending_gaps_ = static_cast<uint16_t>(pending_gaps_ +
                                          (detail::is_gap(code_point) ? 1 : 0));
    return true;
  }
  return take_visible(code_point, cell, line);
}

void LineFinder::find(TextLine& line) noexcept {
  while (take(line)) {
  }
}

// Functions that are not inline leave their stack to those that follow.
__attribute__((noinline)) int32_t ellipsis_width(
    const LayoutOptions& options) noexcept {
  return Pen(options, Pen::logical).ellipsis().width;
}

__attribute__((noinline)) bool is_wider(const LayoutOptions& options,
                                        int32_t units,
                                        int32_t room) noexcept {
  return Pen(options, Pen::logical).from_units(units) > room;
}

__attribute__((noinline)) void find_line(const LayoutOptions& options,
                                         Text text,
                                         int32_t room,
                                         TextLine& line) noexcept {
  LineFinder(options, text, line, room).find(line);
}

// Prepares the order of the paragraph.
void prepare(const LayoutOptions& options, Text text, TextLine& line) noexcept {
  if (options.order() != nullptr) {
    options.order()->prepare(*options.bidi(), text, line.paragraph,
                             options.direction);
    line.base_level = options.bidi()->base_level();
  }
}

// Whether a line's end is that of what Bidi takes for a paragraph: a vertical
// tab, a form feed or a line separator is none.
bool ends_bidi_paragraph(Text text, uint32_t next) noexcept {
  const auto last = static_cast<uint8_t>(text.data[next - 1]);
  const bool is_line_separator =
      last == 0xa8 && next >= 3 &&
      static_cast<uint8_t>(text.data[next - 3]) == 0xe2;
  return last != 0x0b && last != 0x0c && !is_line_separator;
}

// The front of a line that is shortened.
struct Front {
  uint32_t end;
  int32_t width;     // [units of the pen]
  bool has_spacing;  // between its end and what follows
};

// How far a line reaches in `room`, without spaces at its end. Characters keep
// their marks.
__attribute__((noinline)) Front front_of(const LayoutOptions& options,
                                         Text text,
                                         const TextLine& line,
                                         int32_t room) noexcept {
  LineWalk walk(options, text, line);
  Cell cell;
  Front whole = {line.begin, 0, false};
  Front front = whole;
  while (walk.next(line.end(), cell) && cell.x_end <= room) {
    if (!cell.is_mark) {
      whole = front;
    }
    if (cell.has_ink || (cell.is_mark && front.end == cell.begin)) {
      front = {cell.end, cell.x_end, walk.pen().has_begun()};
    }
  }
  return !cell.is_mark || cell.x_end <= room ? front : whole;
}

// In the order of the text, without signs; and where what follows the last tab
// begins.
__attribute__((noinline)) int32_t width_of(const LayoutOptions& options,
                                           Text text,
                                           const TextLine& line,
                                           uint32_t& after_tabs) noexcept {
  LineWalk walk(options, text, line);
  Cell cell;
  after_tabs = line.begin;
  while (walk.next(line.end(), cell)) {
    after_tabs = text.data[cell.begin] == '\t' ? cell.end : after_tabs;
  }
  return walk.pen().at();
}

// Where the back of a line begins that needs no more than `room`, at `from` or
// behind that; then `room` is what it needs. `total` is the line's width.
__attribute__((noinline)) uint32_t back_begin(const LayoutOptions& options,
                                              Text text,
                                              const TextLine& line,
                                              uint32_t from,
                                              int32_t total,
                                              int32_t& room) noexcept {
  Cell cell;
  LineWalk walk(options, text, line);
  while (walk.next(line.end(), cell)) {
    const int32_t width = total - cell.x + walk.pen().spacing();
    if (cell.begin >= from && cell.has_ink && !cell.is_mark && width <= room) {
      room = width;
      return cell.begin;
    }
  }
  room = 0;
  return line.end();
}

__attribute__((noinline)) int32_t spacing_of(
    const LayoutOptions& options) noexcept {
  return Pen(options, Pen::logical).spacing();
}

// A length of the pen's in font units.
__attribute__((noinline)) int32_t to_units(const LayoutOptions& options,
                                           int32_t length) noexcept {
  return Pen(options, Pen::logical).to_units(length);
}

}  // namespace

int32_t detail::room_of(const LayoutOptions& options, Q26_6 width) noexcept {
  return Pen(options, Pen::logical).from_px(width);
}

bool detail::find_next_line(const LayoutOptions& options,
                            Text text,
                            int32_t room,
                            TextLine& line) noexcept {
  if (line.is_found && line.is_last) {
    return false;
  }
  if (!line.is_found && options.bidi() != nullptr) {
    options.bidi()->forget();
  }
  const uint32_t begin = line.next;
  const uint32_t paragraph =
      line.is_found && line.ends_paragraph && ends_bidi_paragraph(text, begin)
          ? begin
          : line.paragraph;
  line = {};
  line.is_found = true;
  line.begin = begin;
  line.paragraph = paragraph;
  prepare(options, text, line);
  find_line(options, text, options.wraps ? room : INT32_MAX, line);
  return true;
}

bool next_line(const LayoutOptions& options,
               Text text,
               Q26_6 width,
               TextLine& line) noexcept {
  const int32_t room = detail::room_of(options, width);
  if (!detail::find_next_line(options, text, room, line)) {
    return false;
  }
  if (!options.wraps && options.ellipsis != Ellipsis::none &&
      is_wider(options, line.width, room)) {
    shorten(options, text, width, line);
  }
  return true;
}

void shorten(const LayoutOptions& options,
             Text text,
             Q26_6 width,
             TextLine& line) noexcept {
  prepare(options, text, line);
  int32_t sign = ellipsis_width(options);
  const int32_t room = detail::room_of(options, width) - sign;
  const bool is_middle =
      options.ellipsis == Ellipsis::middle && !options.wraps && room > 0;
  const Front front =
      front_of(options, text, line, is_middle ? room / 2 : room);
  uint32_t back = line.end();
  int32_t back_width = 0;
  if (is_middle) {
    // Behind tabs, which would have another width.
    uint32_t from = 0;
    const int32_t total = width_of(options, text, line, from);
    from = front.end > from ? front.end : from;
    back_width = room - front.width;
    back = back_begin(options, text, line, from, total, back_width);
  }
  line.has_hyphen = false;
  line.has_ellipsis = true;
  line.skip_at = static_cast<uint16_t>(front.end - line.begin);
  line.skip_length = static_cast<uint16_t>(back - front.end);
  if (!front.has_spacing && line.base_level % 2 != 0) {
    // The front is to the right of the sign, and not spaced from it.
    sign -= spacing_of(options);
  }
  line.width = to_units(options, front.width + sign + back_width);
}

Status lay_out(const LayoutOptions& options,
               Text text,
               const TextLine& line,
               Q26_6 width,
               Span<PositionedGlyph> out,
               Span<const PositionedGlyph>& glyphs) noexcept {
  TextLine prepared = line;
  prepare(options, text, prepared);
  LineCursor cursor(options, text, prepared, width);
  Cell cell;
  size_t count = 0;
  while (cursor.next(cell)) {
    if (!cell.has_ink) {
      continue;
    }
    if (count == out.size) {
      return Status::buffer_small;
    }
    out[count++] = detail::positioned(cursor.pen(), line, cell);
  }
  glyphs = {out.data, count};
  return Status::ok;
}

Q26_6 line_height(const LayoutOptions& options) noexcept {
  if (options.line_height.raw != 0) {
    return options.line_height;
  }
  const FontMetrics metrics = options.face.font->metrics();
  const Q26_6 height =
      to_px(*options.face.font, *options.face.style,
            metrics.ascender - metrics.descender + metrics.line_gap);
  return Q26_6::from_raw((height.raw + 63) & ~63);
}

Q26_6 baseline(const LayoutOptions& options) noexcept {
  const FontMetrics metrics = options.face.font->metrics();
  const Font& font = *options.face.font;
  const TextStyle& style = *options.face.style;
  const int32_t rise = to_px(font, style, metrics.ascender).raw;
  const int32_t depth = -to_px(font, style, metrics.descender).raw;
  const int32_t more = line_height(options).raw - rise - depth;
  const int32_t at = rise + more / 2;
  return Q26_6::from_raw(options.line_height.raw == 0 ? (at + 32) & ~63 : at);
}

}  // namespace inkcell
