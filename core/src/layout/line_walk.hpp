// Walks along a text in its own order, and measures it.
#pragma once

#include <stdint.h>

#include "inkcell/layout.hpp"
#include "layout/pen.hpp"

namespace inkcell {
namespace detail {

// Cells from an offset on, as on a line that begins there.
class LineWalk {
 public:
  LineWalk(const LayoutOptions& options,
           Text text,
           const TextLine& line) noexcept
      : options_(options),
        pen_(options, Pen::logical),
        text_(text),
        rest_(text.data + line.begin, text.size - line.begin) {
    pen_.set_base_level(line.base_level);
  }

  bool at_end() const noexcept { return rest_.size == 0; }
  uint32_t offset() const noexcept {
    return static_cast<uint32_t>(text_.size - rest_.size);
  }
  const Text& rest() const noexcept { return rest_; }
  const Pen& pen() const noexcept { return pen_; }

  // Not at the end: takes the next code point, whose cell put() fills in.
  uint32_t take(Cell& cell) noexcept {
    cell.begin = offset();
    const uint32_t code_point = next_code_point(rest_);
    cell.end = offset();
    return code_point;
  }
  void put(uint32_t code_point, Cell& cell) noexcept {
    pen_.put(code_point,
             options_.order() == nullptr
                 ? uint8_t{0}
                 : options_.order()->level(*options_.bidi(), cell.begin),
             cell);
  }

  // Both, as long as cells begin before `end`.
  bool next(uint32_t end, Cell& cell) noexcept {
    if (at_end() || offset() >= end) {
      return false;
    }
    const uint32_t code_point = take(cell);
    put(code_point, cell);
    return true;
  }

 private:
  const LayoutOptions& options_;
  Pen pen_;
  Text text_;
  Text rest_;
};

}  // namespace detail
}  // namespace inkcell
