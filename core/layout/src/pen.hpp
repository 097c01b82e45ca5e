// Places characters one after the other: faces, advances, kerning, tabs.
#pragma once

#include <stdint.h>

#include "inkcell/layout/layout.hpp"
#include "line_class.hpp"
#include "setting.hpp"
#include "shaped_words.hpp"
#include "text/advances.hpp"
#include "text/blank.hpp"

namespace inkcell::detail {

// Marks belong to the character before them, as far as carets and spacing go.
inline bool is_mark(uint32_t code_point) noexcept {
  return code_point >= 0x300 && is_mark(line_class(code_point));
}

// Justified text is stretched after spaces, and after characters between which
// lines may end without them.
bool is_gap(uint32_t code_point) noexcept;

enum class CellKind : uint8_t {
  other,   // a tab, and what moves nothing
  mark,    // of the character before it
  base,    // spaced from the one before it,
  kerned,  // and kerned
};

// A character on its line. Positions count from the line's left end, in the
// pen's unit: whole pixels where the style has such advances, else font units.
struct LineCell {
  uint32_t begin = 0;  // its bytes in the text
  uint32_t end = 0;
  int32_t x = 0;
  int32_t x_end = 0;
  int32_t x_glyph = 0;
  int16_t y_glyph = 0;  // always in font units
  uint16_t glyph = 0;
  uint8_t face = 0;
  uint8_t level = 0;
  bool has_ink = false;   // `glyph` is to be drawn
  bool is_added = false;  // an ellipsis or a hyphen
  CellKind kind = CellKind::other;

  bool is_mark() const noexcept { return kind == CellKind::mark; }
  bool is_base() const noexcept { return kind >= CellKind::base; }

  // Of a word that was shaped: `glyph` is that of the shaper's, and so many
  // are of its cluster behind it.
  uint8_t more_glyphs = 0;
  uint16_t shaped_glyph = 0;
};

// Where the character before `at` begins, at least `begin`. A character that is
// whole reaches from its lead byte to `at`; any other byte stands alone.
uint32_t previous(const Text& text, uint32_t begin, uint32_t at) noexcept;

// Reads the code point at a byte of a text, and passes it.
inline uint32_t read_code_point(const Text& text, uint32_t& at) noexcept {
  Text rest(text.data + at, text.size - at);
  const uint32_t code_point = next_code_point(rest);
  at = static_cast<uint32_t>(text.size - rest.size);
  return code_point;
}

class Pen {
 public:
  // In the order of the text, or in that of the screen, from left to right.
  enum Order : bool { logical, visual };

  Pen(const Setting& setting, Order order) noexcept;

  // From a length in px, rounded down, and to one in font units.
  int32_t from_px(Q26_6 px) const noexcept;
  int32_t to_units(int32_t length) const noexcept {
    return advances_.to_units(length);
  }
  Q26_6 to_px(int32_t length) const noexcept;
  // A sum of the pen's that is kept in font units.
  int32_t from_units(int32_t units) const noexcept;

  const Setting& setting() const noexcept { return setting_; }
  const LayoutOptions& options() const noexcept { return setting_.options; }
  int32_t at() const noexcept { return at_; }
  // Between two characters.
  int32_t spacing() const noexcept { return spacing_; }
  // Whether spacing comes before the next character.
  bool has_begun() const noexcept { return has_begun_; }
  // Whether there is no more room on any line.
  bool is_at_limit() const noexcept { return at_ == advances_.limit(); }
  void move(int32_t by) noexcept {
    at_ = clamp_to(at_ + by, advances_.limit());
  }
  // Where tab stops count from, in paragraphs that begin at the left; in others
  // tabs have one width, because what they follow stands to their right.
  void set_origin(int32_t at) noexcept { origin_ = at; }
  int32_t origin() const noexcept { return origin_; }
  void set_base_level(uint8_t level) noexcept { has_stops_ = level % 2 == 0; }

  // The next glyph is not kerned; where text stands to its left, as it does in
  // paragraphs that begin there, it is spaced.
  void begin_sign() noexcept {
    begin_run();
    has_begun_ = has_begun_ || has_stops_;
  }

  // Fills in `cell` but for its bytes. Inline, and in steps: the font's tables
  // are read from the caller's frame, on the deepest stack of layout.
  __attribute__((always_inline)) void put(const WordPart& part,
                                          uint32_t code_point,
                                          uint8_t level,
                                          LineCell& cell) noexcept {
    if (put_word(part, code_point, level, cell)) {
      return;
    }
    if (code_point == '\t') {
      look_up_tab(level, cell);
    } else {
      look_up(code_point, level, cell);
    }
    place(kerning(cell), cell);
  }

  // What is put for an ellipsis (three points where no face has one) and a
  // hyphen, none of them kerned, and its width; no sign where no face has any.
  // Spacing comes before each.
  struct Sign {
    uint32_t code_point;
    uint32_t count;
    int32_t width;
  };
  Sign ellipsis() const noexcept;
  Sign hyphen() const noexcept;

  using Glyph = FaceGlyph;
  // In the first face that has it.
  Glyph find(uint32_t code_point) const noexcept;
  // In the face of the span that holds a cell, or as above.
  Glyph find_in(uint32_t code_point, const LineCell& cell) const noexcept {
    const FaceSpans* const spans = options().spans;
    return spans == nullptr ? find(code_point)
                            : spans->find(*this, code_point, cell);
  }

  // For a cluster of the shaper's word: its glyphs from `first` to before
  // `end`, none of a character that belongs to the one before it.
  void put_cluster(uint32_t code_point,
                   uint8_t level,
                   uint32_t first,
                   uint32_t end,
                   LineCell& cell) noexcept;
  void next_glyph(LineCell& cell) const noexcept;

 private:
  bool put_word(const WordPart& part,
                uint32_t code_point,
                uint8_t level,
                LineCell& cell) noexcept;
  void begin_run() noexcept {
    previous_ = {};
    drift_q6_ = 0;
  }
  Glyph find_shown(uint32_t code_point,
                   Shown shown,
                   LineCell& cell) const noexcept;
  void replace(uint32_t code_point, Glyph& glyph) const noexcept;
  int32_t advance(const Glyph& glyph) const noexcept;
  int32_t from_face(uint32_t face,
                    int32_t length,
                    bool is_whole) const noexcept;
  void take_glyph(LineCell& cell) const noexcept;
  int32_t advance_of(const TextGlyph& glyph, uint32_t face) const noexcept;
  void look_up(uint32_t code_point, uint8_t level, LineCell& cell) noexcept;
  int32_t kerning(const LineCell& cell) noexcept;
  void place(int32_t kerning, LineCell& cell) noexcept;
  int32_t digit_width() noexcept;
  int32_t tab_step() const noexcept;
  int32_t next_tab(int32_t step) const noexcept;
  void look_up_tab(uint8_t level, LineCell& cell) noexcept;
  void begin_cell(uint8_t level, LineCell& cell) noexcept;
  int32_t em() const noexcept;
  Sign sign(uint32_t code_point, uint32_t other, uint32_t count) const noexcept;

  const Setting& setting_;
  Advances advances_;
  int32_t at_ = 0;
  int32_t origin_ = 0;
  int32_t spacing_ = 0;
  int32_t digit_width_ = -1;
  int32_t drift_q6_ = 0;  // of OutlineFitter
  Glyph previous_;
  uint8_t previous_level_ = 0;
  bool is_visual_;
  bool keeps_length_;
  bool has_stops_ = true;
  bool has_begun_ = false;
};

}  // namespace inkcell::detail
