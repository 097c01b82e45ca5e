// Text boxes and labels whose text is shaped as it comes.
//
//   static TextGlyph room[64];  // the longest word
//   static TextShaper shaper(room);
//   box.options.set_bidi(bidi);
//   box.options.set_shaper(shaper);
//   box.draw(text, painter);
//
// Faces of fonts that were made with --shape are shaped; text of others is
// drawn character by character.
#pragma once

#include <stdint.h>

#include "inkcell/shaping/shaping.hpp"
#include "inkcell/span.hpp"
#include "inkcell/word_shaper.hpp"

namespace inkcell {

/// Shapes the words of text boxes, labels and lines. One for each task that
/// lays out text.
///
/// Words are shaped one by one where nothing that the font says concerns the
/// space, as in most fonts; else all that is in a line. What is longer than the
/// room is shaped in parts, whose letters join, but become no ligature with
/// those of the next: TextReport::status is then buffer_small.
class TextShaper : public WordShaper {
 public:
  /// `room`: a glyph for each character of the longest word, or line, and some
  /// more where fonts take letters apart; at least 2.
  explicit TextShaper(Span<TextGlyph> room) noexcept;

  /// The same for a program that shapes syllables too: with kDevanagari of
  /// inkcell/shaping/devanagari.hpp.
  TextShaper(Span<TextGlyph> room,
             const detail::SyllableCode& syllables) noexcept
      : TextShaper(room) {
    shaping_.syllables_ = &syllables;
  }

  /// As Shaping::set_language(), of all fonts.
  void set_language(uint32_t tag) noexcept {
    shaping_.set_language(tag);
    forget();
  }

 private:
  static bool open_font(WordShaper& shaper, const Font& font) noexcept;
  static uint32_t shape_part(WordShaper& shaper,
                             const Text& text,
                             uint32_t begin,
                             uint32_t end,
                             bool is_right_to_left) noexcept;

  Span<TextGlyph> room_;
  Shaping shaping_;
  const Font* font_ = nullptr;       // that shaping_ is of,
  const uint8_t* tables_ = nullptr;  // and its section; null: it has none
};

}  // namespace inkcell
