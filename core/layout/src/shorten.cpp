// Ends lines with an ellipsis.
#include "next_line.hpp"

#include "line_walk.hpp"

namespace inkcell::detail {
namespace {

// Not inline, for its size, but for the deepest step.
__attribute__((noinline)) bool next_cell(LineWalk& walk,
                                         const TextLine& line,
                                         LineCell& cell) noexcept {
  return walk.next(line.end(), cell);
}

// What is left of a line on both sides of an ellipsis.
struct Cut {
  struct Front {
    uint32_t end;
    int32_t width;
    bool has_spacing;  // between it and what follows
  };
  int32_t room;     // [units of the pen]
  int32_t spacing;  // of characters
  Front front;
  uint32_t back_begin;
  int32_t back_width = 0;
};

// The ellipsis, and what is left of a width. Functions that are not inline
// leave their stack to those that follow.
__attribute__((noinline)) Pen::Sign begin_cut(const Setting& setting,
                                              Q26_6 width,
                                              Cut& cut) noexcept {
  const Pen pen(setting, Pen::logical);
  const Pen::Sign ellipsis = pen.ellipsis();
  cut.room = pen.from_px(width) - ellipsis.width;
  cut.spacing = pen.spacing();
  return ellipsis;
}

// How far a line reaches in the room, without spaces at its end. Characters
// keep their marks.
__attribute__((noinline)) void cut_front(const Setting& setting,
                                         const Text& text,
                                         const TextLine& line,
                                         int32_t room,
                                         Cut::Front& front) noexcept {
  LineWalk walk(setting, text, line, line.end());
  LineCell cell;
  front = {line.begin, 0, false};
  Cut::Front whole = front;
  while (walk.next(line.end(), cell) && cell.x_end <= room) {
    if (!cell.is_mark()) {
      whole = front;
    }
    if (cell.has_ink || (cell.is_mark() && front.end == cell.begin)) {
      front = {cell.end, cell.x_end, walk.pen().has_begun()};
    }
  }
  if (cell.is_mark() && cell.x_end > room) {
    front = whole;
  }
}

// The line's width in the order of the text, without signs. `back_begin` is
// then what the back may begin with at the earliest: the front's end, and
// behind tabs, which would have another width.
__attribute__((noinline)) int32_t width_of(const Setting& setting,
                                           const Text& text,
                                           const TextLine& line,
                                           Cut& cut) noexcept {
  LineWalk walk(setting, text, line, line.end());
  LineCell cell;
  cut.back_begin = cut.front.end;
  while (next_cell(walk, line, cell)) {
    if (text.data[cell.begin] == '\t' && cell.end > cut.back_begin) {
      cut.back_begin = cell.end;
    }
  }
  return walk.pen().at();
}

// The longest back that leaves room for the front. `width` is the line's.
__attribute__((noinline)) void cut_back(const Setting& setting,
                                        const Text& text,
                                        const TextLine& line,
                                        int32_t width,
                                        Cut& cut) noexcept {
  LineWalk walk(setting, text, line, line.end());
  LineCell cell;
  while (next_cell(walk, line, cell)) {
    const int32_t back = width - cell.x + walk.pen().spacing();
    if (cell.begin >= cut.back_begin && cell.has_ink && !cell.is_mark() &&
        back <= cut.room - cut.front.width) {
      cut.back_begin = cell.begin;
      cut.back_width = back;
      return;
    }
  }
  cut.back_begin = line.end();
}

// A length of the pen's in font units.
__attribute__((noinline)) int32_t to_units(const Setting& setting,
                                           int32_t length) noexcept {
  return Pen(setting, Pen::logical).to_units(length);
}

}  // namespace

void shorten_line(const Setting& setting,
                  const Text& text,
                  Q26_6 width,
                  TextLine& line) noexcept {
  const ShapedWords* const words = setting.options.words();
  Cut cut;
  const Pen::Sign ellipsis = begin_cut(setting, width, cut);
  int32_t sign = ellipsis.width;
  const bool is_middle = setting.options.ellipsis == Ellipsis::middle &&
                         !setting.options.wraps && cut.room > 0;
  cut_front(setting, text, line, is_middle ? cut.room / 2 : cut.room,
            cut.front);
  cut.back_begin = line.end();
  if (is_middle) {
    cut_back(setting, text, line, width_of(setting, text, line, cut), cut);
  }
  if (words != nullptr) {
    cut.front.width =
        words->width(setting, text, line, line.begin, cut.front.end);
  }
  if (words != nullptr && cut.back_begin != line.end()) {
    cut.back_width =
        words->width(setting, text, line, cut.back_begin, line.end()) +
        cut.spacing;
  }
  line.has_hyphen = false;
  line.has_ellipsis = true;
  line.skip_at = static_cast<uint16_t>(cut.front.end - line.begin);
  line.skip_length = static_cast<uint16_t>(cut.back_begin - cut.front.end);
  if (line.base_level % 2 != 0 && !cut.front.has_spacing &&
      (ellipsis.count != 0 || cut.back_begin != line.end())) {
    // The front is to the right of the sign, and not spaced from it or, where
    // no face has a sign, from the back.
    sign -= cut.spacing;
  }
  line.width = to_units(setting, cut.front.width + sign + cut.back_width);
}

}  // namespace inkcell::detail
