// Text that comes at run time, shaped: letters that join, ligatures, marks.
//
//   Shaping shaping;
//   INKCELL_TRY(Shaping::open(font, shaping));
//   RunGlyph room[64];
//   Span<RunGlyph> glyphs(room);
//   ScriptRun run = shaping.first_run(text, 0, text.size);
//   INKCELL_TRY(shaping.shape(text, run, glyphs));
//
// The font names its scripts: inkcell-fontgen --shape arab,hebr,thai,latn. Its
// section SHAP holds what the source font says, compiled, and gives the glyphs
// and positions of HarfBuzz.
//
// A run has one direction and one script. Directions come first, from Bidi of
// inkcell/layout/bidi.hpp; first_run() and next_run() part them by script.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/text.hpp"

namespace inkcell {

/// A glyph of a run, in visual order. [font units, y up] The 16 bytes that a
/// caller lends for each.
struct RunGlyph {
  uint16_t glyph = 0;
  /// Number of the code point in the run; of the first one where several make
  /// glyphs together. A caret stands at its side, and never within.
  uint16_t cluster = 0;
  int16_t advance = 0;
  int16_t x = 0;  // where it is drawn, from the pen
  int16_t y = 0;

  // Of shaping alone.
  int8_t link = 0;        // to what it is attached; before: number of a mark
  uint8_t flags = 0;      // detail::kIgnorable ...
  uint8_t kind = 0;       // class, and forms
  uint8_t row = 0;        // of its class and lookups; before: order of marks
  uint8_t ligature = 0;   // its number; before: joining type
  uint8_t component = 0;  // of a ligature; before: bits of the code point
};

/// Characters of one script, by their bytes.
struct ScriptRun {
  size_t begin = 0;
  size_t end = 0;
  /// Of the font, for these characters; kNoProgram: they need none, or the font
  /// has none. They are then drawn side by side.
  uint8_t program = kNoProgram;
  /// By the script; Bidi knows better.
  bool is_right_to_left = false;

  static constexpr uint8_t kNoProgram = 255;
};

namespace detail {
// Where the tables of SHAP begin, in bits, and how wide they are.
struct ShapeTables {
  Span<const uint8_t> bytes;
  uint32_t scripts = 0;
  uint32_t programs = 0;
  uint32_t entries = 0;
  uint32_t spans = 0;
  uint32_t characters = 0;
  uint32_t properties = 0;
  uint32_t marks = 0;
  uint32_t compositions = 0;
  uint32_t mirrors = 0;
  uint32_t lookups = 0;
  uint32_t sets = 0;
  uint32_t glyph_rows = 0;
  uint32_t rows = 0;
  uint32_t data = 0;

  // False: they do not fit the section.
  bool open(Span<const uint8_t> section) noexcept;
};
}  // namespace detail

/// Shapes runs with the tables of one font. Constant after `open` but for the
/// language, so that any number of tasks may shape with a copy at once.
///
/// The tables are untrusted, as all of a font: whatever the bytes are, and even
/// if they change later, no call reads outside, writes outside of the room, or
/// fails to end.
class Shaping {
 public:
  constexpr Shaping() noexcept = default;

  /// `font` must outlive it. unsupported: the font was made without --shape;
  /// corrupt: the section's tables do not fit. `out` is untouched unless the
  /// result is ok.
  static Status open(const Font& font, Shaping& out) noexcept;

  /// Chooses forms of a language by its tag of OpenType, such as
  /// format::tag('U', 'R', 'D', ' '); without a program of it in the font, and
  /// by 0, those of the script.
  void set_language(uint32_t tag) noexcept { language_ = tag; }

  /// The run at the beginning of the bytes [begin, end), which must not be
  /// empty, lie in `text` and begin and end between characters. Spaces, digits,
  /// punctuation and marks belong to the script before them, or else behind.
  ScriptRun first_run(const Text& text,
                      size_t begin,
                      size_t end) const noexcept;
  /// The run behind `run`; false if it ended at `end`.
  bool next_run(const Text& text, size_t end, ScriptRun& run) const noexcept;

  /// Shapes a run into `glyphs`, which has its glyphs then, from left to right.
  /// Letters join with those of `text` beside it.
  ///
  /// buffer_small: the room is too small; twice the characters are enough for
  /// most text. unsupported: the font's tables took more work than its header
  /// allows, or nested deeper than four. bad_argument: more than 65535
  /// characters, or a run outside of the text. `glyphs` is then empty.
  Status shape(const Text& text,
               const ScriptRun& run,
               Span<RunGlyph>& glyphs) const noexcept;

 private:
  uint32_t program_of(uint32_t code_point) const noexcept;

  const Font* font_ = nullptr;
  detail::ShapeTables tables_;
  uint32_t language_ = 0;
};

}  // namespace inkcell
