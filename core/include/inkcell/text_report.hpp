// What becomes of characters that a font lacks, and how texts went.
//
//   TextReport report;
//   report.instead = '?';
//   Painter painter(canvas, ram, nullptr, &report);
//   painter.text(font, style, pen, words);
//   if (report.status != Status::ok) { ... }  // perhaps report.first_missing
//
// A painter without a report draws boxes, and does not link what is here.
#pragma once

#include <stdint.h>

#include "inkcell/status.hpp"

namespace inkcell {

class Font;
struct TextReport;

namespace detail {
// Finds a glyph for a character that a font lacks. False: nothing is drawn.
using ReplaceMissing = bool(TextReport& report,
                            const Font& font,
                            uint32_t code_point,
                            uint16_t& glyph) noexcept;
ReplaceMissing replace_missing;
}  // namespace detail

/// Lies in the caller's memory; a Painter points to it. For one task at a time.
struct TextReport {
  static constexpr uint32_t kBox = UINT32_MAX;  // the font's .notdef
  static constexpr uint32_t kNothing = UINT32_MAX - 1;

  /// What is drawn for a character that is missing: kBox, kNothing, or another
  /// character; a box if that is missing, too.
  uint32_t instead = kBox;
  /// Asked first: another code point for one that is missing, such as 'e' for
  /// an accented one. Null: none is.
  uint32_t (*substitute)(uint32_t code_point) noexcept = nullptr;

  /// Characters for which `instead` was taken, and the first of them. Whoever
  /// reads a text counts: each strip, and what measures. Set it to 0 to count
  /// anew.
  uint32_t missing = 0;
  uint32_t first_missing = 0;
  /// The first of these since it was `ok`, which the caller may set again:
  /// no_glyph: a character was missing. cut: a line ended early, after 2^24
  /// font units or ValueLabel::kMostBytes. needs_shaping: in a box, a label or
  /// a line of a LineShaper letters were not joined, or marks not placed
  /// (docs/LAYOUT.md). buffer_small: the room of a TextShaper was too small for
  /// a word, or a line of a font where spaces count, whose parts were then
  /// shaped apart.
  /// bad_argument: a text box has no font, or an empty clip.
  Status status = Status::ok;

  void note(Status what) noexcept {
    status = status == Status::ok ? what : status;
  }

  /// For a character that is missing: `find`, given a code point, looks for a
  /// glyph, and leaves .notdef where there is none. False: draw nothing.
  template <typename Find>
  bool find_instead(uint32_t code_point, const Find& find) noexcept {
    if (substitute != nullptr && find(substitute(code_point))) {
      return true;
    }
    if (missing++ == 0) {
      first_missing = code_point;
    }
    note(Status::no_glyph);
    // No font has a glyph for kBox.
    return instead != kNothing && (find(instead) || true);
  }

  // Linked by whoever makes a report.
  detail::ReplaceMissing* replace = &detail::replace_missing;
};

}  // namespace inkcell
