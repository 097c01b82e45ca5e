// Glyphs of text that is shaped at run time, and who shapes it for layout:
// TextShaper of inkcell/shaping/text_shaper.hpp, or one of your own.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/text.hpp"

namespace inkcell {

/// A glyph of a run, in visual order. [font units, y up] The 16 bytes that a
/// caller lends for each.
struct TextGlyph {
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

namespace detail {
// The word that was shaped last: where layout found it.
struct WordAtHand {
  const char* text = nullptr;  // null: there is none
  const Font* font = nullptr;
  uint32_t start = 0;  // of what it was looked for from
  uint32_t begin = 0;
  uint32_t end = 0;
  uint32_t part_end = 0;
  uint8_t face = 0;
  uint8_t level = 0;
  bool starts_itself = false;  // not where the part of a line did
};
}  // namespace detail

/// Shapes the words of lines (LayoutOptions::set_shaper()). One for each task
/// that lays out text.
struct WordShaper {
  /// Makes a font the one to shape with. False: it shapes no text of it.
  using Open = bool(WordShaper& shaper, const Font& font) noexcept;

  /// Shapes the beginning of the bytes [begin, end) of a text, which are of one
  /// direction and begin and end between characters, as text that goes on at
  /// both ends. Returns where the part ends, behind `begin`. `glyphs` are then
  /// those of the part, from left to right, whose clusters count bytes from
  /// `begin` on; none: it is drawn character by character.
  using Shape = uint32_t(WordShaper& shaper,
                         const Text& text,
                         uint32_t begin,
                         uint32_t end,
                         bool is_right_to_left) noexcept;

  /// `most`: the characters that `shape` takes at a time, at least one.
  constexpr WordShaper(Open* open_font,
                       Shape* shape_part,
                       uint32_t most) noexcept
      : open(open_font), shape(shape_part), most_characters(most) {}

  Open* open;
  Shape* shape;
  uint32_t most_characters;
  /// Of the font: whether words are shaped alone, not with spaces.
  bool parts_at_spaces = false;
  /// Of the glyphs: whether they join, so that nothing may part them.
  bool joins = false;
  /// Of the glyphs: whether the room was too small for more. Layout tells it to
  /// the painter's TextReport.
  bool is_cut = false;
  Span<const TextGlyph> glyphs;
  detail::WordAtHand at_hand;

  /// Call it when text was changed in place. Text boxes call it themselves.
  void forget() noexcept { at_hand.text = nullptr; }
};

}  // namespace inkcell
