// Text as glyphs that can move, each with its word and line.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/motion/pose.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/shaped_run.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/text.hpp"

namespace inkcell::motion {

/// A glyph with ink. [font units, y up, from the run's origin on the baseline
/// of the first line]
struct RunGlyph {
  int32_t x = 0;
  int32_t y = 0;
  int32_t advance = 0;  // of its letter: x + advance / 2 is the middle of that
  uint16_t glyph = 0;
  uint16_t word = 0;  // counted from the start of the text
  uint16_t line = 0;
  /// Twice the number of gaps between the line's anchor and the glyph: the
  /// factor of tracking.
  int16_t half_gaps = 0;
  /// Counted from the start of the text: a letter with its marks, a ligature.
  uint16_t letter = 0;
};

/// A laid-out text. `glyphs` is in the caller's buffer.
struct Run {
  Span<const RunGlyph> glyphs;
  uint16_t letters = 0;
  uint16_t words = 0;
  uint16_t lines = 0;
  int32_t width = 0;        // of the longest line [font units]
  int32_t line_height = 0;  // [font units]
};

/// Lays text out with the font's advances and kerning. A line feed starts a
/// line, whose anchor stands at the run's origin. Glyphs without ink separate
/// words and are left out. With a LineShaper of the painter
/// (inkcell/layout/line_shaper.hpp) letters join and keep their marks; its sink
/// does not matter. Tracking parts letters that join.
///
/// buffer_small: `out` holds fewer glyphs than the text; text.size suffice, but
/// where a shaper takes letters apart. `run` is then untouched.
Status lay_out(const Painter& painter,
               const Font& font,
               Text text,
               Anchor anchor,
               Span<RunGlyph> out,
               Run& run) noexcept;

/// The same without a shaper: letters are not joined, and marks not placed.
Status lay_out(const Font& font,
               Text text,
               Anchor anchor,
               Span<RunGlyph> out,
               Run& run) noexcept;

/// The same of a line that was shaped when the program was built: ligatures,
/// joined Arabic letters, placed marks. It is one word, each glyph a letter.
///
/// buffer_small: `out` holds fewer glyphs than the line; text.glyphs.size
/// always suffice. `run` is then untouched.
Status lay_out(const Font& font,
               const ShapedRun& text,
               Anchor anchor,
               Span<RunGlyph> out,
               Run& run) noexcept;

/// The units that a stagger counts, and the unit of a glyph. `glyph`: its
/// letter, of which marks are a part.
enum class Unit : uint8_t { glyph, word, line };
/// How many a run has.
uint32_t unit_count(const Run& run, Unit unit) noexcept;
/// `index` < run.glyphs.size.
uint32_t unit_of(const Run& run, Unit unit, size_t index) noexcept;

/// Where a run stands on the screen.
struct RunPlace {
  Point origin;    // of the run [px]
  Q26_6 size;      // [px to the em]
  Q26_6 tracking;  // additional space between glyphs [px]
  /// The height of the pivot above the baseline. [1/1000 of the size] A quarter
  /// of the em is the middle of lower-case letters.
  int16_t pivot_height = 250;
};

/// Places glyph `index` < run.glyphs.size on a straight line. Its pivot is in
/// the middle of its advance.
PosedGlyph place(const Font& font,
                 const Run& run,
                 size_t index,
                 const RunPlace& where,
                 const Pose& pose) noexcept;

/// The height of a pivot above the baseline. [1/1000 of the size -> px] The
/// size is clamped to 0..kMaxSize, the result to +-32767 px.
Q16_16 pivot_height_px(Q26_6 size, int16_t height) noexcept;

/// Font units at a size, to the nearest 1/65536 px. Clamped to +-32767 px; the
/// size to 0..kMaxSize.
Q16_16 to_px_q16(const Font& font, Q26_6 size, int32_t units) noexcept;

}  // namespace inkcell::motion
