// Lines of text: UTF-8 to positioned glyphs, which painter.hpp draws.
//
// Layout as designed knows no size: positions are in font units, unrounded, so
// that one layout serves every size, strip and frame. Text that is fitted
// across (FitOptions::across, canvases of 1 and 2 bits) has advances that
// depend on the size: Painter lays it out and measures it as it draws it. One
// line at a time, left to right; layout.hpp has lines that break, and mixed
// directions.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text_report.hpp"

namespace inkcell {

/// UTF-8 bytes that somebody else owns. Any bytes are allowed: each maximal
/// part that is not well formed reads as one U+FFFD (Unicode 15, section 3.9).
struct Text {
  const char* data = nullptr;
  size_t size = 0;  // [bytes]

  constexpr Text() noexcept = default;
  constexpr Text(const char* bytes, size_t count) noexcept
      : data(bytes), size(count) {}
  /// A zero-terminated string.
  constexpr Text(const char* string) noexcept : data(string) {
    while (string[size] != '\0') {
      ++size;
    }
  }
#if defined(__cpp_char8_t)
  /// The same: u8"21.5 \u00b0C" of C++20.
  Text(const char8_t* string) noexcept
      : Text(reinterpret_cast<const char*>(string)) {}
#endif
};

/// Takes the first code point off `text`, which must not be empty.
uint32_t next_code_point(Text& text) noexcept;

/// The whole characters of its first `most` bytes.
Text cut(Text text, size_t most) noexcept;

/// Whether text shows .notdef where a font lacks a code point. Controls, zero
/// width characters and soft hyphens show nothing; spaces and tabs need none of
/// their own beside U+0020.
bool needs_glyph(uint32_t code_point) noexcept;

/// A glyph of a run. Font units, y up, from the run's origin on the baseline.
struct PositionedGlyph {
  int32_t x = 0;
  int16_t y = 0;
  uint16_t glyph = 0;
  uint16_t offset = 0;  // of its first byte in the line
  uint8_t face = 0;     // 0: the run's own; others: fallback[face - 1]
};

/// The longest line whose glyphs know their offsets. [bytes]
inline constexpr size_t kMaxLineBytes = 65535;

/// A font and the style that draws it. Both must outlive it.
struct Face {
  const Font* font = nullptr;
  const Style* style = nullptr;
};

/// Where a letter stands on its line, with its marks, in reading order: one
/// that runs to the left begins at its right. [font units]
struct LetterEdges {
  int32_t begin = 0;
  int32_t end = 0;
  bool is_right_to_left = false;
};

class Painter;
class TextCursor;

namespace detail {
// Lays lines out otherwise than glyph by glyph, one at a time: LineShaper of
// inkcell/layout/line_shaper.hpp.
struct LineSetter {
  void (*begin)(LineSetter& self,
                const Painter& painter,
                const TextCursor& line) noexcept;
  bool (*next)(LineSetter& self, PositionedGlyph& out) noexcept;
  LetterEdges (*letter)(const LineSetter& self) noexcept;

 protected:
  // Of a line that begins.
  static Face face_of(const TextCursor& line) noexcept;
  static Text text_of(const TextCursor& line) noexcept;
};
}  // namespace detail

/// Lays text out glyph by glyph, without a buffer.
///
///   TextCursor cursor(font, "AV");
///   PositionedGlyph glyph;
///   while (cursor.next(glyph)) { ... }
///   // cursor.advance() is the width of the line
///
/// `font`, the text and the style must outlive it.
class TextCursor {
 public:
  /// As designed. A report says what to do with missing characters, and must
  /// outlive it.
  TextCursor(const Font& font, Text text, TextReport* report = nullptr) noexcept
      : font_(font), text_(text), size_(text.size), report_(report) {}

  /// With the advances that glyphs have when the style draws them. If those are
  /// whole pixels, so are positions, in font units to the nearest; two digits
  /// are not kerned; a pixel more or less between two other glyphs of different
  /// widths now and then keeps the line as long as it is designed.
  TextCursor(const Font& font,
             Text text,
             const Style& style,
             TextReport* report = nullptr) noexcept;

  /// The same as a painter lays it out, which must outlive it: with its report,
  /// and shaped if it has a LineShaper, which then lays out no other line
  /// meanwhile.
  TextCursor(const Painter& painter,
             const Font& font,
             Text text,
             const Style& style) noexcept;

  /// The next glyph, kerned against the one before; false at the end, where
  /// `out` has no values. A code point that the font lacks gives .notdef, or
  /// what the report says, unless it shows nothing: tabs and other spaces are
  /// then as wide as the font's space, and have no width if it has none;
  /// combining marks take no room; controls, line ends, soft hyphens, zero
  /// width characters and variation selectors never give a glyph.
  bool next(PositionedGlyph& out) noexcept;

  /// Whether advances are whole pixels, by fitting.
  bool is_in_whole_px() const noexcept { return fitter_ != nullptr; }

  /// Where the next glyph would stand without kerning. [font units, at most
  /// 2^24 in magnitude] Of a line that is shaped: letter().end.
  int32_t advance() const noexcept;

  /// The letter of the glyph that next() gave. After the last one: begin 0, end
  /// the width of the line, or what next() gave last where nothing is shaped.
  LetterEdges letter() const noexcept;

 private:
  friend detail::LineSetter;

  __attribute__((always_inline)) void set_style(const Style& style) noexcept {
    style_ = &style;
    fitter_ = style.has_whole_advances() ? style.fitter() : nullptr;
  }

  const Font& font_;
  Text text_;
  size_t size_;
  const Style* style_ = nullptr;
  const Fitter* fitter_ = nullptr;  // null: advances are the font's
  TextReport* report_;
  detail::LineSetter* setter_ = nullptr;
  int32_t advance_ = 0;    // [px with a style, or font units]
  int32_t previous_ = -1;  // glyph id, or -1 at the start of the line
  int32_t drift_q6_ = 0;   // of a pen in whole pixels, ahead of the design [px]
};

inline Face detail::LineSetter::face_of(const TextCursor& line) noexcept {
  return {&line.font_, line.style_};
}
inline Text detail::LineSetter::text_of(const TextCursor& line) noexcept {
  return line.text_;
}

/// What of a line stands at its origin.
enum class Anchor : uint8_t { left, centre, right };

/// Width and ink of a line in font units, y up, from its origin.
struct TextMeasure {
  int32_t advance = 0;
  int32_t x_min = 0;  // the ink box is empty if x_max <= x_min
  int32_t y_min = 0;
  int32_t x_max = 0;
  int32_t y_max = 0;
};

/// Of what a cursor has left.
TextMeasure measure(const Font& font, TextCursor cursor) noexcept;
/// Of a text as designed.
inline TextMeasure measure(const Font& font, Text text) noexcept {
  return measure(font, TextCursor(font, text));
}

/// A length in font units at a style's size, rounded to the nearest 1/64 px and
/// clamped to the range of Q26_6.
Q26_6 to_px(const Font& font, const Style& style, int32_t units) noexcept;

/// TextMeasure in px from the line's origin, y down, before the style turns it.
struct PixelMeasure {
  Q26_6 advance;
  Q26_6 left;
  Q26_6 top;
  Q26_6 right;
  Q26_6 bottom;
};

/// A measure in pixels of a style.
PixelMeasure to_px(const Font& font,
                   const Style& style,
                   const TextMeasure& measure) noexcept;

}  // namespace inkcell
