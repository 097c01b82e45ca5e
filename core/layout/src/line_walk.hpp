// Walks along a text in its own order, and measures it.
#pragma once

#include <stdint.h>

#include "inkcell/layout/layout.hpp"
#include "pen.hpp"

namespace inkcell::detail {

// Cells from an offset on, as on a line that begins there. The text must
// outlive it.
class LineWalk {
 public:
  // Words end at `end`, if not before.
  LineWalk(const Setting& setting,
           const Text& text,
           const TextLine& line,
           uint32_t end) noexcept
      : pen_(setting, Pen::logical),
        part_{text, line.begin, end},
        at_(line.begin) {
    pen_.set_base_level(line.base_level);
  }

  bool at_end() const noexcept { return at_ == part_.text.size; }
  uint32_t offset() const noexcept { return at_; }
  Text rest() const noexcept {
    return {part_.text.data + at_, part_.text.size - at_};
  }
  const Pen& pen() const noexcept { return pen_; }

  void skip_byte() noexcept { ++at_; }

  // Not at the end: takes the next code point, whose cell put() fills in.
  uint32_t take(LineCell& cell) noexcept {
    cell.begin = at_;
    const uint32_t code_point = read_code_point(part_.text, at_);
    cell.end = at_;
    return code_point;
  }
  // Inline, as Pen::put().
  __attribute__((always_inline)) void put(uint32_t code_point,
                                          LineCell& cell) noexcept {
    pen_.put(part_, code_point, level(cell.begin), cell);
  }

  // Both, as long as cells begin before `end`.
  __attribute__((always_inline)) bool next(uint32_t end,
                                           LineCell& cell) noexcept {
    if (at_end() || at_ >= end) {
      return false;
    }
    const uint32_t code_point = take(cell);
    put(code_point, cell);
    return true;
  }

 private:
  uint8_t level(uint32_t at) const noexcept { return pen_.setting().level(at); }

  Pen pen_;
  const WordPart part_;
  uint32_t at_;
};

}  // namespace inkcell::detail
