// The lines of a text box, one after the other.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/layout/text_box.hpp"
#include "line_cursor.hpp"
#include "next_line.hpp"

namespace inkcell::detail {

// Lines and boxes lie within this. [px, Q6]
inline constexpr int32_t kFarthest = 1 << 28;

inline Q26_6 box_width(const TextBox& box) noexcept {
  return Q26_6::from_int(box.rect.x1 - box.rect.x0);
}

inline int32_t line_step(const TextBox& box) noexcept {
  return detail::clamp_to(line_height(box.options).raw, kFarthest);
}

// The lines of a box, one after the other: those that are given, or found anew.
// What it is made from must outlive it.
class BoxLines {
 public:
  BoxLines(const TextBox& box,
           const Painter& painter,
           const Text& text,
           const Span<const TextLine>& given) noexcept;

  const TextBox& box() const noexcept { return box_; }
  const Setting& setting() const noexcept { return setting_; }
  const TextLine& line() const noexcept { return line_; }
  // Whether next() would find none.
  bool is_last() const noexcept { return line_.is_last || count_ == most_; }

  bool next() noexcept;

  // Where the first line begins, from the top of the screen. [px, Q6] Only
  // before next() was called.
  int32_t top() noexcept;

  // For the line at hand: its directions, and its glyphs from the left.
  void prepare() const noexcept {
    static_cast<void>(detail::prepare(setting_, text_, line_));
  }
  LineCursor cursor() const noexcept {
    LineCursor cursor(setting_, text_, line_);
    cursor.align(box_width(box_));
    return cursor;
  }

 private:
  bool is_given() const noexcept { return given_.data != nullptr; }

  const TextBox& box_;
  const Setting setting_;
  const Text& text_;
  const Span<const TextLine>& given_;
  TextLine line_;
  size_t count_ = 0;
  size_t most_;
};

}  // namespace inkcell::detail
