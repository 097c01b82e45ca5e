// What layout calls for words that are shaped. Linked with
// LayoutOptions::set_shaper().
#pragma once

#include <stdint.h>

#include "inkcell/layout/layout.hpp"

namespace inkcell::detail {

class Pen;
struct LineCell;
struct Setting;

// A part of a line: what may be shaped with a character.
struct WordPart {
  const Text& text;
  uint32_t begin;
  uint32_t end;
};

struct ShapedWords {
  // As Pen::put(). False: the character is not shaped.
  bool (*put)(Pen& pen,
              const WordPart& part,
              uint32_t code_point,
              uint8_t level,
              LineCell& cell);
  // Goes to the next glyph of a cell that has one.
  void (*next_glyph)(const Pen& pen, LineCell& cell);
  // Whether a character belongs to the one before it.
  bool (*continues)(const Pen& pen,
                    const WordPart& part,
                    uint8_t level,
                    uint32_t at);
  // Finds the width of a line anew if it ends within a word: the part of a word
  // may have other forms than the whole.
  void (*measure_cut)(const Setting& setting, const Text& text, TextLine& line);
  // That of a part of a line, without signs, whose words are cut at its ends.
  // [units of the pen]
  int32_t (*width)(const Setting& setting,
                   const Text& text,
                   const TextLine& line,
                   uint32_t begin,
                   uint32_t end);
};

}  // namespace inkcell::detail
