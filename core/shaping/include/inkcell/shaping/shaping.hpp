// Text that comes at run time, shaped: letters that join, ligatures, marks.
//
//   Shaping shaping;
//   INKCELL_TRY(Shaping::open(font, shaping));
//   TextGlyph room[64];
//   Span<TextGlyph> glyphs(room);
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
#include "inkcell/word_shaper.hpp"

namespace inkcell {

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
class Shaper;

enum class SyllableStep : uint8_t { split, part, order_first, order_last };

/// Scripts whose letters change places in syllables: a part that is linked
/// where a program names it.
struct SyllableCode {
  void (*run)(Shaper& shaper, SyllableStep step) noexcept;
};

// Where the tables of SHAP begin, in bits, and how wide their rows are.
struct ShapeTables {
  static constexpr uint32_t kNumbers = 24;
  static constexpr uint32_t kTables = 14;

  Span<const uint8_t> bytes;
  uint16_t numbers[kNumbers];  // of the header
  uint32_t begins[kTables];
  uint16_t row_bits[kTables];

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
  /// result is ok, and keeps its language.
  static Status open(const Font& font, Shaping& out) noexcept;

  /// The same for a program that shapes syllables too: with kDevanagari of
  /// inkcell/shaping/devanagari.hpp.
  static Status open(const Font& font,
                     const detail::SyllableCode& syllables,
                     Shaping& out) noexcept {
    INKCELL_TRY(open(font, out));
    out.syllables_ = &syllables;
    return Status::ok;
  }

  /// Chooses forms of a language by its tag of OpenType, such as
  /// format::tag('U', 'R', 'D', ' '); without a program of it in the font, and
  /// by 0, those of the script.
  void set_language(uint32_t tag) noexcept { language_ = tag; }

  /// Whether nothing that the font says concerns the space: words that are
  /// shaped alone are what they are in their line.
  bool parts_at_spaces() const noexcept;
  /// Whether the letters of a run join.
  bool joins(const ScriptRun& run) const noexcept;

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
  /// allows, or nested deeper than four, or the script has syllables, and
  /// open() was called without their code. bad_argument: more than 65535
  /// characters, or a run outside of the text. `glyphs` is then empty.
  Status shape(const Text& text,
               const ScriptRun& run,
               Span<TextGlyph>& glyphs) const noexcept;

 private:
  friend class TextShaper;

  uint32_t program_of(uint32_t code_point) const noexcept;

  const Font* font_ = nullptr;
  const detail::SyllableCode* syllables_ = nullptr;
  detail::ShapeTables tables_ = {};
  uint32_t language_ = 0;
};

}  // namespace inkcell
