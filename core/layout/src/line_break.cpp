#include "inkcell/layout/line_break.hpp"

#include "line_class.hpp"

namespace inkcell {
namespace detail {
namespace {

// A set of classes that have rows. Bit i: class i.
constexpr uint32_t set() noexcept {
  return 0;
}
template <typename... Rest>
constexpr uint32_t set(LineClass first, Rest... rest) noexcept {
  return uint32_t{1} << static_cast<uint8_t>(first) | set(rest...);
}
constexpr bool has(uint32_t classes, LineClass c) noexcept {
  return is_pair_class(c) && (classes >> static_cast<uint8_t>(c) & 1) != 0;
}

constexpr uint32_t kLetters = set(LineClass::al, LineClass::hl);
constexpr uint32_t kOpening = set(LineClass::op, LineClass::opw);
constexpr uint32_t kClosing = set(LineClass::cl, LineClass::cp);
constexpr uint32_t kAffixes = set(LineClass::pr, LineClass::po);
constexpr uint32_t kPictures = set(LineClass::id, LineClass::eb, LineClass::em);
constexpr uint32_t kJamo = set(
    LineClass::jl, LineClass::jv, LineClass::jt, LineClass::h2, LineClass::h3);
// Never at the beginning of a line, even after spaces: LB11, LB13.
constexpr uint32_t kTrailing =
    kClosing | set(LineClass::ex, LineClass::is, LineClass::sy, LineClass::wj);

// The classes that stay on the line of a class `before` which they follow, by
// the rules that look at two characters. LB12, LB12a and LB15 need no more than
// is said here; LB25 and LB30a have states of their own.
constexpr uint32_t stays_after(LineClass before) noexcept {
  constexpr uint32_t kAll = (uint32_t{1} << kPairClasses) - 1;
  if (has(set(LineClass::wj, LineClass::gl) | kOpening | set(LineClass::qu),
          before)) {
    return kAll;  // LB11, LB12, LB14, LB19
  }
  uint32_t after = kTrailing | set(LineClass::qu);  // LB13, LB19
  if (!has(set(LineClass::ba, LineClass::hy), before)) {
    after |= set(LineClass::gl);  // LB12a
  }
  if (has(kClosing, before)) {
    after |= set(LineClass::ns);  // LB16
  }
  if (before == LineClass::b2) {
    after |= set(LineClass::b2);  // LB17
  }
  if (before == LineClass::cb) {
    return after;  // LB20
  }
  after |= set(LineClass::ba, LineClass::hy, LineClass::ns,
               LineClass::in);  // LB21, LB22
  if (before == LineClass::bb) {
    after |= kAll & ~set(LineClass::cb);  // LB21
  }
  if (before == LineClass::sy) {
    after |= set(LineClass::hl);  // LB21b
  }
  if (has(kLetters, before)) {
    after |= set(LineClass::nu) | kAffixes | kLetters;  // LB23, LB24, LB28
  }
  if (before == LineClass::nu) {
    after |= kLetters;  // LB23
  }
  if (before == LineClass::pr) {
    after |= kPictures | kJamo;  // LB23a, LB27
  }
  if (has(kPictures | kJamo, before)) {
    after |= set(LineClass::po);  // LB23a, LB27
  }
  if (has(kAffixes, before)) {
    after |= kLetters | set(LineClass::nu);  // LB24, LB25
  }
  if (before == LineClass::hy) {
    after |= set(LineClass::nu);  // LB25
  }
  if (before == LineClass::jl) {
    after |= set(LineClass::jl, LineClass::jv, LineClass::h2,
                 LineClass::h3);  // LB26
  }
  if (has(set(LineClass::jv, LineClass::h2), before)) {
    after |= set(LineClass::jv, LineClass::jt);
  }
  if (has(set(LineClass::jt, LineClass::h3), before)) {
    after |= set(LineClass::jt);
  }
  if (before == LineClass::is) {
    after |= kLetters;  // LB29
  }
  if (has(kLetters | set(LineClass::nu), before)) {
    after |= set(LineClass::op);  // LB30
  }
  if (before == LineClass::cp) {
    after |= kLetters | set(LineClass::nu);  // LB30
  }
  if (before == LineClass::eb) {
    after |= set(LineClass::em);  // LB30b
  }
  return after;
}

struct PairTable {
  uint32_t rows[kPairClasses] = {};

  constexpr PairTable() noexcept {
    for (uint8_t i = 0; i < kPairClasses; ++i) {
      rows[i] = stays_after(static_cast<LineClass>(i));
    }
  }
};

constexpr PairTable kPairs;

// Whether a digit follows, after marks.
bool begins_with_digit(Text text) noexcept {
  while (text.size != 0) {
    const LineClass next = line_class(next_code_point(text));
    if (!is_mark(next)) {
      return next == LineClass::nu;
    }
  }
  return false;
}

}  // namespace

Break LineState::decide_after_spaces(LineClass after) const noexcept {
  const bool stays =
      has(kTrailing, after) || has(kOpening, before_) ||     // LB14
      (before_ == LineClass::qu && has(kOpening, after)) ||  // LB15
      (has(kClosing, before_) && after == LineClass::ns) ||  // LB16
      (before_ == LineClass::b2 && after == LineClass::b2);  // LB17
  return stays ? Break::none : Break::allowed;               // LB18
}

// The rules in their order. `before_` has a row unless a line ends with it, or
// spaces begin the text, or it is a zero width space.
Break LineState::decide(LineClass after, const Text& rest) const noexcept {
  if (before_ == LineClass::none && !is_spaced_) {
    return Break::none;  // LB2
  }
  if (ends_line(before_)) {
    return before_ == LineClass::cr && after == LineClass::lf
               ? Break::none
               : Break::mandatory;
  }
  if (ends_line(after) || after == LineClass::sp || after == LineClass::zw) {
    return Break::none;  // LB6, LB7
  }
  if (before_ == LineClass::zw) {
    return Break::allowed;  // LB8
  }
  if (is_joined_) {
    return Break::none;  // LB8a
  }
  if (is_mark(after)) {
    if (!is_spaced_) {
      return Break::none;  // LB9
    }
    after = LineClass::al;  // LB10
  }
  if (is_spaced_) {
    return decide_after_spaces(after);
  }
  if (has(kPairs.rows[static_cast<uint8_t>(before_)], after)) {
    return Break::none;
  }
  const bool is_in_number =
      (number_ == digits &&
       has(set(LineClass::nu, LineClass::sy, LineClass::is) | kClosing |
               kAffixes,
           after)) ||
      (number_ == closed && has(kAffixes, after)) ||
      (has(kAffixes, before_) && has(kOpening | set(LineClass::hy), after) &&
       begins_with_digit(rest));  // LB25
  const bool is_after_hyphen = is_hebrew_hyphen_ && after != LineClass::cb;
  const bool is_flag = is_odd_flag_ && before_ == LineClass::ri &&
                       after == LineClass::ri;  // LB30a
  return is_in_number || is_after_hyphen || is_flag ? Break::none
                                                    : Break::allowed;
}

void LineState::go_past(LineClass after) noexcept {
  is_joined_ = after == LineClass::zwj;
  if (after == LineClass::sp && !ends_line(before_)) {
    is_spaced_ = true;
    number_ = none;
    return;
  }
  if (is_mark(after)) {
    if (is_pair_class(before_) && !is_spaced_) {
      return;  // LB9
    }
    after = LineClass::al;  // LB10
  }
  const bool follows = !is_spaced_;
  if (after == LineClass::nu) {
    number_ = digits;
  } else if (number_ == digits && has(kClosing, after)) {
    number_ = closed;
  } else if (!(number_ == digits &&
               (after == LineClass::sy || after == LineClass::is))) {
    number_ = none;
  }
  is_hebrew_hyphen_ =
      follows && before_ == LineClass::hl &&
      (after == LineClass::hy || after == LineClass::ba);  // LB21a
  is_odd_flag_ = after == LineClass::ri &&
                 !(follows && before_ == LineClass::ri && is_odd_flag_);
  is_spaced_ = after == LineClass::sp;
  before_ = after == LineClass::sp ? LineClass::none : after;
}

Break LineState::step(LineClass after, const Text& rest) noexcept {
  const Break result = decide(after, rest);
  go_past(after);
  return result;
}

}  // namespace detail

// The characters before a place that is found are past: it is the offset of the
// one that was read last.
bool LineBreaker::next(LineBreak& out) noexcept {
  while (rest_.size != 0) {
    const size_t offset = text_.size - rest_.size;
    const uint32_t code_point = next_code_point(rest_);
    const detail::Break found =
        state_.step(detail::line_class(code_point), rest_);
    if (found != detail::Break::none) {
      out = {offset, found == detail::Break::mandatory};
      return true;
    }
  }
  if (is_done_ || text_.size == 0) {
    return false;
  }
  is_done_ = true;
  out = {text_.size, true};
  return true;
}

}  // namespace inkcell
