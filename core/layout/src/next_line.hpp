// The steps of next_line(), one after the other: none has the stack of another
// below it.
#pragma once

#include <stdint.h>

#include "inkcell/layout/layout.hpp"

namespace inkcell {
namespace detail {

// Finds the order of the line's paragraph, which what follows takes for
// granted. Returns its level.
inline uint8_t prepare(const LayoutOptions& options,
                       const Text& text,
                       const TextLine& line) noexcept {
  return options.order() == nullptr
             ? uint8_t{0}
             : options.order()->prepare(options, text, line.paragraph);
}

// Goes to the beginning of the next line. False after the last.
bool begin_line(const LayoutOptions& options,
                const Text& text,
                TextLine& line) noexcept;

// Where a line may end.
enum class LineEnds : uint8_t { at_breaks, anywhere };

// Finds where it ends, but for an ellipsis.
void find_end(const LayoutOptions& options,
              const Text& text,
              Q26_6 width,
              TextLine& line,
              LineEnds ends = LineEnds::at_breaks) noexcept;

// Whether a line that does not wrap is to be shortened.
bool is_too_wide(const LayoutOptions& options,
                 Q26_6 width,
                 const TextLine& line) noexcept;

// Before shorten_line(): what follows its last whole word fills the line.
inline void fill_line(const LayoutOptions& options,
                      const Text& text,
                      Q26_6 width,
                      TextLine& line) noexcept {
  if (options.wraps) {
    line.ends_paragraph = false;
    line.is_last = false;
    find_end(options, text, width, line, LineEnds::anywhere);
  }
}

// Ends the line with an ellipsis.
void shorten_line(const LayoutOptions& options,
                  const Text& text,
                  Q26_6 width,
                  TextLine& line) noexcept;

// As lay_out(); without a width the line begins at 0.
Status lay_out_in(const LayoutOptions& options,
                  const Text& text,
                  const TextLine& line,
                  const Q26_6* width,
                  Span<PositionedGlyph> out,
                  Span<const PositionedGlyph>& glyphs) noexcept;

inline bool find_next_line(const LayoutOptions& options,
                           const Text& text,
                           Q26_6 width,
                           TextLine& line) noexcept {
  if (!begin_line(options, text, line)) {
    return false;
  }
  line.base_level = prepare(options, text, line);
  find_end(options, text, width, line);
  if (is_too_wide(options, width, line)) {
    shorten_line(options, text, width, line);
  }
  return true;
}

}  // namespace detail
}  // namespace inkcell
