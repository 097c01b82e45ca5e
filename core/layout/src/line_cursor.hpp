// Walks along a line from left to right, as it is seen.
#pragma once

#include <stdint.h>

#include "inkcell/layout/layout.hpp"
#include "pen.hpp"

namespace inkcell::detail {

class LineCursor {
 public:
  // A line that next_line() found. Its paragraph has been prepared. Text and
  // line must outlive it.
  LineCursor(const Setting& setting,
             const Text& text,
             const TextLine& line) noexcept;

  // Before next(): aligns the line in a room. Else it begins at its left end.
  void align(Q26_6 width) noexcept;

  // The next character; false at the right end. Positions count from the left
  // end of the lines' room: they are aligned.
  bool next(LineCell& cell) noexcept {
    if (!advance()) {
      return false;
    }
    put(cell);
    return true;
  }

  // Of a cell with ink: its next glyph; false: it was the last.
  bool next_glyph(LineCell& cell) const noexcept {
    if (cell.more_glyphs == 0) {
      return false;
    }
    pen_.options().words()->next_glyph(pen_, cell);
    return true;
  }

  const Pen& pen() const noexcept { return pen_; }
  // Where the line begins and where it ends. [units of the pen]
  int32_t left() const noexcept { return left_; }
  int32_t right() const noexcept { return right_; }

 private:
  // What a line is made of, in the order of the text.
  enum Part : uint8_t { front, ellipsis, back, hyphen, none };

  bool advance() noexcept;
  bool begin_part() noexcept;
  void begin_sign(const Pen::Sign& sign, uint32_t at) noexcept;
  void begin_text(uint32_t begin, uint32_t end) noexcept;
  void begin_run() noexcept;
  bool begin_character() noexcept;
  bool begin_cluster() noexcept;
  bool continues(uint32_t at) noexcept;
  WordPart part() const noexcept {
    return {text_, static_cast<uint32_t>(run_.begin),
            static_cast<uint32_t>(run_.end)};
  }
  void put(LineCell& cell) noexcept;
  uint32_t take(LineCell& cell) noexcept;
  void stretch(uint32_t code_point, LineCell& cell) noexcept;

  const Text& text_;
  const TextLine& line_;
  Pen pen_;
  int32_t left_ = 0;
  int32_t right_ = 0;
  int32_t gap_ = 0;         // what justified text gains at each gap,
  uint16_t wide_gaps_ = 0;  // and how many of them gain one more
  uint8_t steps_ = 0;       // parts that have begun
  uint8_t added_ = 0;       // signs that are left of an ellipsis or a hyphen
  uint16_t sign_ = 0;       // its code point
  bool is_in_text_ = false;
  // The text of a part, its run, and what is left of a cluster of that. Runs to
  // the right are one cluster; of others [run_.begin, rest_end_) is left.
  uint32_t part_begin_ = 0;
  uint32_t part_end_ = 0;
  BidiRun run_;
  uint32_t rest_end_ = 0;
  uint32_t at_ = 0;
  uint32_t cluster_end_ = 0;
};

// A cell's glyph in the units of the font.
inline PositionedGlyph positioned(const Pen& pen,
                                  const TextLine& line,
                                  const LineCell& cell) noexcept {
  PositionedGlyph glyph;
  glyph.x = pen.to_units(cell.x_glyph);
  glyph.y = cell.y_glyph;
  glyph.glyph = cell.glyph;
  glyph.offset = static_cast<uint16_t>(cell.begin - line.begin);
  glyph.face = cell.face;
  return glyph;
}

}  // namespace inkcell::detail
