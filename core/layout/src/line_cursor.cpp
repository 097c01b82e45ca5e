#include "line_cursor.hpp"

namespace inkcell::detail {
LineCursor::LineCursor(const Setting& setting,
                       const Text& text,
                       const TextLine& line) noexcept
    : text_(text), line_(line), pen_(setting, Pen::visual) {
  right_ = pen_.from_units(line.width);
  pen_.set_base_level(line.base_level);
}

void LineCursor::align(Q26_6 width) noexcept {
  const int32_t room = pen_.from_px(width) - right_;
  const bool is_rtl = line_.base_level % 2 != 0;
  const Align align = pen_.options().align;
  if (align == Align::justify && room > 0 && line_.gaps != 0 &&
      !line_.ends_paragraph && !line_.has_ellipsis) {
    const uint32_t gaps = line_.gaps;
    gap_ = static_cast<int32_t>(static_cast<uint32_t>(room) / gaps);
    wide_gaps_ = static_cast<uint16_t>(static_cast<uint32_t>(room) % gaps);
    right_ += room;
    return;
  }
  if (align == Align::centre) {
    left_ = room / 2;
  } else if (align == Align::right || (is_rtl && align != Align::left)) {
    left_ = room;
  }
  right_ += left_;
  pen_.move(left_);
  pen_.set_origin(left_);
}

// In the order of the screen: the other way round where the paragraph begins at
// the right. False at the end of the line.
bool LineCursor::begin_part() noexcept {
  if (steps_ == none) {
    return false;
  }
  const bool is_rtl = line_.base_level % 2 != 0;
  const auto part = static_cast<Part>(is_rtl ? hyphen - steps_ : steps_);
  ++steps_;
  const uint32_t skip = line_.begin + line_.skip_at;
  switch (part) {
    case front:
      begin_text(line_.begin, line_.has_ellipsis ? skip : line_.end());
      break;
    case ellipsis:
      if (line_.has_ellipsis) {
        begin_sign(pen_.ellipsis(), skip);
      }
      break;
    case back:
      if (line_.has_ellipsis) {
        begin_text(skip + line_.skip_length, line_.end());
      }
      break;
    default:
      if (line_.has_hyphen) {
        begin_sign(pen_.hyphen(), line_.end());
      }
  }
  return true;
}

void LineCursor::begin_sign(const Pen::Sign& sign, uint32_t at) noexcept {
  sign_ = static_cast<uint16_t>(sign.code_point);
  added_ = static_cast<uint8_t>(sign.count);
  at_ = at;
  pen_.begin_sign();
}

void LineCursor::begin_text(uint32_t begin, uint32_t end) noexcept {
  is_in_text_ = begin < end;
  part_begin_ = begin;
  part_end_ = end;
  if (!is_in_text_) {
    return;
  }
  run_ = {begin, end, 0};
  const LayoutOptions& options = pen_.options();
  if (options.order() != nullptr) {
    run_ = options.order()->first_run(*options.bidi(), begin, end);
  }
  begin_run();
}

void LineCursor::begin_run() noexcept {
  const auto begin = static_cast<uint32_t>(run_.begin);
  const auto end = static_cast<uint32_t>(run_.end);
  const bool is_rtl = run_.is_right_to_left();
  at_ = begin;
  cluster_end_ = is_rtl ? begin : end;
  rest_end_ = is_rtl ? end : begin;
}

// The bytes of the character at at_, or of a sign.
uint32_t LineCursor::take(LineCell& cell) noexcept {
  cell.begin = at_;
  cell.end = at_;
  cell.is_added = !is_in_text_;
  if (cell.is_added) {
    --added_;
    return sign_;
  }
  const uint32_t code_point = read_code_point(text_, at_);
  cell.end = at_;
  return code_point;
}

void LineCursor::put(LineCell& cell) noexcept {
  const uint32_t code_point = take(cell);
  pen_.put(cell.is_added ? WordPart{text_, 0, 0} : part(), code_point,
           cell.is_added ? uint8_t{0} : run_.level, cell);
  if (cell.is_added) {
    pen_.begin_sign();
  } else {
    stretch(code_point, cell);
  }
}

// Gaps of justified text: after spaces and ideographs, but for the last
// character of the line.
void LineCursor::stretch(uint32_t code_point, LineCell& cell) noexcept {
  if ((gap_ != 0 || wide_gaps_ != 0) && cell.end != line_.end() &&
      is_gap(code_point)) {
    const int32_t wide = wide_gaps_ != 0 ? 1 : 0;
    wide_gaps_ = static_cast<uint16_t>(wide_gaps_ - wide);
    pen_.move(gap_ + wide);
    pen_.set_origin(pen_.origin() + gap_ + wide);
    cell.x_end = pen_.at();
  }
}

// The next one to the left: a character with the marks that follow it. False:
// the run is at its end.
bool LineCursor::begin_cluster() noexcept {
  const auto begin = static_cast<uint32_t>(run_.begin);
  if (rest_end_ == begin) {
    return false;
  }
  cluster_end_ = rest_end_;
  do {
    rest_end_ = previous(text_, begin, rest_end_);
  } while (rest_end_ != begin && continues(rest_end_));
  at_ = rest_end_;
  return true;
}

// Whether a character of the run belongs to the one before it.
bool LineCursor::continues(uint32_t at) noexcept {
  const ShapedWords* const words = pen_.options().words();
  return words != nullptr ? words->continues(pen_, part(), run_.level, at)
                          : is_mark(read_code_point(text_, at));
}

// Goes to the next character; false: the part is at its end.
bool LineCursor::begin_character() noexcept {
  const LayoutOptions& options = pen_.options();
  while (at_ >= cluster_end_) {
    if (begin_cluster()) {
      break;
    }
    if (options.order() == nullptr ||
        !options.order()->next_run(*options.bidi(), part_begin_, part_end_,
                                   run_)) {
      is_in_text_ = false;
      return false;
    }
    begin_run();
  }
  return true;
}

// Goes to the next character or sign; false: the line is at its end.
bool LineCursor::advance() noexcept {
  while (!(is_in_text_ && begin_character()) && added_ == 0) {
    if (!begin_part()) {
      return false;
    }
  }
  return true;
}

}  // namespace inkcell::detail
