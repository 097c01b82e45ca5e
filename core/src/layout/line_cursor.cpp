#include "layout/line_cursor.hpp"

namespace inkcell {
namespace detail {
namespace {

// Where the character before `at` begins, at least `begin`. A character that is
// whole reaches from its lead byte to `at`; any other byte stands alone.
uint32_t previous(const Text& text, uint32_t begin, uint32_t at) noexcept {
  for (uint32_t size = 1; size <= 4 && size <= at - begin; ++size) {
    const uint32_t from = at - size;
    if ((static_cast<uint8_t>(text.data[from]) & 0xc0) != 0x80) {
      Text part(text.data + from, size);
      static_cast<void>(next_code_point(part));
      return part.size == 0 ? from : at - 1;
    }
  }
  return at - 1;
}

uint32_t code_point_at(const Text& text, uint32_t at) noexcept {
  Text rest(text.data + at, text.size - at);
  return next_code_point(rest);
}

}  // namespace

LineCursor::LineCursor(const LayoutOptions& options,
                       Text text,
                       const TextLine& line,
                       Q26_6 width) noexcept
    : options_(options), text_(text), line_(line), pen_(options, Pen::visual) {
  const int32_t room = pen_.from_px(width) - pen_.from_units(line.width);
  const bool is_rtl = line.base_level % 2 != 0;
  Align align = options.align;
  if (align == Align::justify && room > 0 && line.gaps != 0 &&
      !line.ends_paragraph && !line.has_ellipsis) {
    const uint32_t gaps = line.gaps;
    gap_ = static_cast<int32_t>(static_cast<uint32_t>(room) / gaps);
    wide_gaps_ = static_cast<uint32_t>(room) % gaps;
  } else if (align == Align::center) {
    left_ = room / 2;
  } else if (align == Align::right || (is_rtl && align != Align::left)) {
    left_ = room;
  }
  right_ = left_ + pen_.from_units(line.width);
  if (gap_ != 0 || wide_gaps_ != 0) {
    right_ += room;
  }
  pen_.move(left_);
  pen_.set_origin(left_);
  pen_.set_base_level(line.base_level);
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
  sign_ = sign;
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
  if (options_.order() != nullptr) {
    run_ = options_.order()->first_run(*options_.bidi(), begin, end);
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

// The character at at_.
void LineCursor::put(Cell& cell) noexcept {
  Text rest(text_.data + at_, text_.size - at_);
  const uint32_t code_point = next_code_point(rest);
  cell.begin = at_;
  cell.end = static_cast<uint32_t>(text_.size - rest.size);
  cell.is_added = false;
  pen_.put(code_point, run_.level, cell);
  stretch(code_point, cell);
  at_ = cell.end;
}

void LineCursor::put_sign(Cell& cell) noexcept {
  --added_;
  cell.begin = at_;
  cell.end = at_;
  pen_.put(sign_.code_point, 0, cell);
  cell.is_added = true;
  pen_.begin_sign();
}

// Gaps of justified text: after spaces and ideographs, but for the last
// character of the line.
void LineCursor::stretch(uint32_t code_point, Cell& cell) noexcept {
  if ((gap_ != 0 || wide_gaps_ != 0) && cell.end != line_.end() &&
      is_gap(code_point)) {
    const int32_t wide = wide_gaps_ != 0 ? 1 : 0;
    wide_gaps_ -= wide_gaps_ != 0 ? 1 : 0;
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
  } while (rest_end_ != begin && is_mark(code_point_at(text_, rest_end_)));
  at_ = rest_end_;
  return true;
}

// False: the part is at its end.
bool LineCursor::next_in_text(Cell& cell) noexcept {
  while (at_ >= cluster_end_) {
    if (begin_cluster()) {
      break;
    }
    if (options_.order() == nullptr ||
        !options_.order()->next_run(*options_.bidi(), part_begin_, part_end_,
                                    run_)) {
      is_in_text_ = false;
      return false;
    }
    begin_run();
  }
  put(cell);
  return true;
}

bool LineCursor::next(Cell& cell) noexcept {
  for (;;) {
    if (is_in_text_ && next_in_text(cell)) {
      return true;
    }
    if (added_ != 0) {
      put_sign(cell);
      return true;
    }
    if (!begin_part()) {
      return false;
    }
  }
}

}  // namespace detail
}  // namespace inkcell
