// Where lines of a text may end: Unicode's line breaking, UAX #14.
//
// The text boxes of text_box.hpp break lines themselves; this is for layouts of
// your own. All of Unicode 15 but U+10000 to U+1EFFF, whose characters count as
// letters. Scripts that need a dictionary (Thai, Lao, Khmer, Burmese) break at
// spaces and zero width spaces only.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/text.hpp"

namespace inkcell {

namespace detail {

enum class LineClass : uint8_t;
enum class Break : uint8_t { none, allowed, mandatory };

/// What the rules need to know of the characters before a place.
class LineState {
 public:
  /// Whether a line may end before a character of class `after`, and goes past
  /// the character. `rest` is the text that follows it.
  Break step(LineClass after, const Text& rest) noexcept;

 private:
  /// Where a number of rule LB25 stands.
  enum Number : uint8_t { none, digits, closed };
  static constexpr uint8_t kNothing = 255;  // LineClass::none

  Break decide(LineClass after, const Text& rest) const noexcept;
  Break decide_after_spaces(LineClass after) const noexcept;
  void go_past(LineClass after) noexcept;

  // The last character that is neither a space nor a mark.
  LineClass before_ = static_cast<LineClass>(kNothing);
  Number number_ = none;
  bool is_spaced_ = false;         // spaces follow it
  bool is_joined_ = false;         // the last character is a joiner
  bool is_hebrew_hyphen_ = false;  // it is a hyphen after a Hebrew letter
  bool is_odd_flag_ = false;       // it is the first half of a flag
};

}  // namespace detail

/// A place where a line may end, before the byte `offset`.
struct LineBreak {
  size_t offset = 0;
  bool is_mandatory = false;  // after a line feed or the like
};

/// Finds them one after the other, without a buffer.
///
///   LineBreaker breaker("well-known words");
///   LineBreak place;
///   while (breaker.next(place)) { ... }  // 5, 11, 16
///
/// The text must outlive it.
class LineBreaker {
 public:
  explicit LineBreaker(Text text) noexcept : text_(text), rest_(text) {}

  /// The next place; the last one is the end of the text, which is mandatory.
  /// False after that, and for an empty text.
  bool next(LineBreak& out) noexcept;

 private:
  Text text_;
  Text rest_;
  detail::LineState state_;
  bool is_done_ = false;
};

}  // namespace inkcell
