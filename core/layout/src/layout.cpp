#include "inkcell/layout/layout.hpp"

#include "line_cursor.hpp"
#include "line_walk.hpp"
#include "next_line.hpp"

namespace inkcell {

using detail::LineCell;
using detail::LineWalk;
using detail::Pen;
using detail::Setting;

namespace {

// Spaces that do not count where a line ends.
bool hangs(uint32_t code_point, detail::LineClass line_class) noexcept {
  return code_point == ' ' ||
         (code_point != '\t' && line_class == detail::LineClass::ba &&
          detail::shown_as(code_point) == detail::Shown::space);
}

// Goes along a text until there is no more room. The line itself keeps the best
// place for its end that was seen so far, its width in units of the pen.
class LineFinder {
 public:
  LineFinder(const Setting& setting,
             const Text& text,
             int32_t room,
             detail::LineEnds ends,
             TextLine& line) noexcept
      : walk_(setting, text, line, static_cast<uint32_t>(text.size)),
        line_(line),
        room_(room),
        end_(line.begin),
        ends_(ends) {
    line_.next = line.begin;
  }

  void find() noexcept {
    while (take()) {
    }
    line_.width = walk_.pen().to_units(line_.width);
    TextReport* const report = walk_.pen().setting().painter.report();
    if (walk_.pen().is_at_limit() && report != nullptr) {
      report->note(Status::cut);
    }
  }

 private:
  // One character; false: the line is at its end.
  bool take() noexcept {
    if (walk_.at_end()) {
      end_paragraph(0);
      line_.is_last = true;
      return false;
    }
    LineCell cell;
    const uint32_t code_point = walk_.take(cell);
    const auto line_class = detail::line_class(code_point);
    const detail::Break place = state_.step(line_class, walk_.rest());
    if (detail::ends_line(line_class)) {
      end_paragraph(code_point);
      return false;
    }
    if (place == detail::Break::allowed &&
        ends_ == detail::LineEnds::at_breaks && end_ != line_.begin) {
      keep_place(cell.begin);
    }
    is_after_hyphen_ =
        code_point == 0xad && cell.begin == end_ && walk_.pen().has_begun();
    walk_.put(code_point, cell);
    // What has no width goes with spaces before it.
    const bool is_behind_spaces =
        !cell.has_ink && cell.x_end == cell.x && cell.begin != end_;
    if (is_behind_spaces || hangs(code_point, line_class)) {
      pending_gaps_ = static_cast<uint16_t>(
          pending_gaps_ + (detail::is_gap(code_point) ? 1 : 0));
      return true;
    }
    return take_visible(code_point, cell);
  }

  // False: the line is full. It holds a character with its marks, even if there
  // is no room, but never more than kMaxLineBytes.
  bool take_visible(uint32_t code_point, const LineCell& cell) noexcept {
    const bool is_long = cell.end - line_.begin > kMaxLineBytes;
    if (!has_place_ && (!cell.is_mark() || cell.begin != end_ ||
                        (is_long && line_.next == line_.begin))) {
      end_at(cell.begin);
    }
    if (is_long || (line_.next != line_.begin && cell.x_end > room_)) {
      return false;
    }
    gaps_ = static_cast<uint16_t>(gaps_ + pending_gaps_);
    pending_gaps_ = detail::is_gap(code_point) ? 1 : 0;
    end_ = cell.end;
    width_ = cell.x_end;
    return true;
  }

  // A line may end before `at`.
  void keep_place(uint32_t at) noexcept {
    const int32_t hyphen = is_after_hyphen_ ? walk_.pen().hyphen().width : 0;
    if (is_after_hyphen_ && width_ + hyphen > room_) {
      return;
    }
    end_at(at);
    line_.width += hyphen;
    line_.has_hyphen = is_after_hyphen_;
    has_place_ = true;
  }

  void end_at(uint32_t next) noexcept {
    line_.next = next;
    line_.length = static_cast<uint16_t>(end_ - line_.begin);
    line_.gaps = gaps_;
    line_.width = width_;
    line_.has_hyphen = false;
  }

  void end_paragraph(uint32_t code_point) noexcept {
    if (code_point == '\r' && !walk_.at_end() && walk_.rest().data[0] == '\n') {
      walk_.skip_byte();
    }
    end_at(walk_.offset());
    line_.ends_paragraph = true;
  }

  LineWalk walk_;
  detail::LineState state_;
  TextLine& line_;
  int32_t room_;
  // What the line shows up to the character that was read last.
  uint32_t end_;
  int32_t width_ = 0;
  uint16_t gaps_ = 0;
  uint16_t pending_gaps_ = 0;  // that count if something follows them
  bool is_after_hyphen_ = false;
  bool has_place_ = false;  // where a line may end
  detail::LineEnds ends_;
};

__attribute__((noinline)) int32_t room_of(const Setting& setting,
                                          Q26_6 width) noexcept {
  return Pen(setting, Pen::logical).from_px(width);
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

}  // namespace

bool detail::begin_line(const Text& text, TextLine& line) noexcept {
  if (line.is_found && line.is_last) {
    return false;
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
  return true;
}

void detail::find_end(const Setting& setting,
                      const Text& text,
                      Q26_6 width,
                      TextLine& line,
                      detail::LineEnds ends) noexcept {
  const int32_t room =
      setting.options.wraps ? room_of(setting, width) : INT32_MAX;
  LineFinder(setting, text, room, ends, line).find();
  if (setting.options.words() != nullptr) {
    setting.options.words()->measure_cut(setting, text, line);
  }
}

bool detail::is_too_wide(const Setting& setting,
                         Q26_6 width,
                         const TextLine& line) noexcept {
  const Pen pen(setting, Pen::logical);
  return !setting.options.wraps && setting.options.ellipsis != Ellipsis::none &&
         pen.from_units(line.width) > pen.from_px(width);
}

bool next_line(const LayoutOptions& options,
               const Painter& painter,
               Text text,
               Q26_6 width,
               TextLine& line) noexcept {
  if (!line.is_found) {
    options.forget();
  }
  return detail::find_next_line({options, painter}, text, width, line);
}

void shorten(const LayoutOptions& options,
             const Painter& painter,
             Text text,
             Q26_6 width,
             TextLine& line) noexcept {
  const Setting setting = {options, painter};
  line.base_level = detail::prepare(setting, text, line);
  detail::fill_line(setting, text, width, line);
  detail::shorten_line(setting, text, width, line);
}

Status detail::lay_out_in(const Setting& setting,
                          const Text& text,
                          const TextLine& line,
                          const Q26_6* width,
                          Span<PositionedGlyph> out,
                          Span<const PositionedGlyph>& glyphs) noexcept {
  detail::LineCursor cursor(setting, text, line);
  if (width != nullptr) {
    cursor.align(*width);
  }
  LineCell cell;
  size_t count = 0;
  while (cursor.next(cell)) {
    for (bool has_glyph = cell.has_ink; has_glyph;
         has_glyph = cursor.next_glyph(cell)) {
      if (count == out.size) {
        return Status::buffer_small;
      }
      out[count++] = detail::positioned(cursor.pen(), line, cell);
    }
  }
  glyphs = {out.data, count};
  return Status::ok;
}

Status lay_out(const LayoutOptions& options,
               const Painter& painter,
               Text text,
               const TextLine& line,
               Q26_6 width,
               Span<PositionedGlyph> out,
               Span<const PositionedGlyph>& glyphs) noexcept {
  const Setting setting = {options, painter};
  static_cast<void>(detail::prepare(setting, text, line));
  return detail::lay_out_in(setting, text, line, &width, out, glyphs);
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
  const Style& style = *options.face.style;
  const int32_t rise = to_px(font, style, metrics.ascender).raw;
  const int32_t depth = -to_px(font, style, metrics.descender).raw;
  const int32_t more = line_height(options).raw - rise - depth;
  const int32_t at = rise + more / 2;
  return Q26_6::from_raw(options.line_height.raw == 0 ? (at + 32) & ~63 : at);
}

}  // namespace inkcell
