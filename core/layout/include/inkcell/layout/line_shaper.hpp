// Single lines that are shaped as they come: Painter::text(), measures, boxes,
// ValueLabel, and type that moves.
//
//   static TextGlyph room[64];
//   static TextShaper shaper(room);
//   static uint16_t cells[256];
//   static Bidi bidi(cells);
//   static LineShaper lines(shaper, bidi);
//   const Painter shaping = painter.with(lines);
//   shaping.text(font, style, pen, text);
#pragma once

#include <stdint.h>

#include "inkcell/layout/layout.hpp"
#include "inkcell/painter.hpp"

namespace inkcell {

/// Shapes and orders what painters draw, line by line. One for each task that
/// draws text. Text ends at its first line feed.
class LineShaper : public detail::LineSetter {
 public:
  /// Both must outlive it, and may serve text boxes, too.
  LineShaper(WordShaper& shaper, Bidi& bidi) noexcept;

 private:
  static void begin_line(LineSetter& self,
                         const Painter& painter,
                         const TextCursor& line) noexcept;
  static bool next_glyph(LineSetter& self, PositionedGlyph& out) noexcept;
  static LetterEdges letter_of(const LineSetter& self) noexcept;

  struct Line;
  Line& line() noexcept { return *reinterpret_cast<Line*>(line_); }

  LayoutOptions options_;
  // A Line.
  static constexpr size_t kLineBytes = 136 + 15 * sizeof(void*);
  alignas(void*) uint8_t line_[kLineBytes] = {};
};

}  // namespace inkcell
