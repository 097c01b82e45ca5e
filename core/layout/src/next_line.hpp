// The steps of next_line(), one after the other: none has the stack of another
// below it.
#pragma once

#include <stdint.h>

#include "setting.hpp"

namespace inkcell::detail {

// Finds the order of the line's paragraph, which what follows takes for
// granted. Returns its level.
inline uint8_t prepare(const Setting& setting,
                       const Text& text,
                       const TextLine& line) noexcept {
  const BidiOrder* const order = setting.options.order();
  return order == nullptr
             ? uint8_t{0}
             : order->prepare(setting.options, text, line.paragraph);
}

// Goes to the beginning of the next line. False after the last.
bool begin_line(const Text& text, TextLine& line) noexcept;

// Where a line may end.
enum class LineEnds : uint8_t { at_breaks, anywhere };

// Finds where it ends, but for an ellipsis.
void find_end(const Setting& setting,
              const Text& text,
              Q26_6 width,
              TextLine& line,
              LineEnds ends = LineEnds::at_breaks) noexcept;

// Whether a line that does not wrap is to be shortened.
bool is_too_wide(const Setting& setting,
                 Q26_6 width,
                 const TextLine& line) noexcept;

// Before shorten_line(): what follows its last whole word fills the line.
inline void fill_line(const Setting& setting,
                      const Text& text,
                      Q26_6 width,
                      TextLine& line) noexcept {
  if (setting.options.wraps) {
    line.ends_paragraph = false;
    line.is_last = false;
    find_end(setting, text, width, line, LineEnds::anywhere);
  }
}

// Ends the line with an ellipsis.
void shorten_line(const Setting& setting,
                  const Text& text,
                  Q26_6 width,
                  TextLine& line) noexcept;

// As lay_out(); without a width the line begins at 0.
Status lay_out_in(const Setting& setting,
                  const Text& text,
                  const TextLine& line,
                  const Q26_6* width,
                  Span<PositionedGlyph> out,
                  Span<const PositionedGlyph>& glyphs) noexcept;

// The first line of a text that is one, whatever its length.
inline TextLine first_line(const Setting& setting, const Text& text) noexcept {
  setting.options.forget();
  TextLine line;
  static_cast<void>(begin_line(text, line));
  line.base_level = prepare(setting, text, line);
  find_end(setting, text, Q26_6::from_raw(INT32_MAX), line);
  return line;
}

inline bool find_next_line(const Setting& setting,
                           const Text& text,
                           Q26_6 width,
                           TextLine& line) noexcept {
  if (!begin_line(text, line)) {
    return false;
  }
  line.base_level = prepare(setting, text, line);
  find_end(setting, text, width, line);
  if (is_too_wide(setting, width, line)) {
    shorten_line(setting, text, width, line);
  }
  return true;
}

}  // namespace inkcell::detail
