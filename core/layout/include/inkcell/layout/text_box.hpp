// Text in a rectangle: wrapped, aligned, shortened; with carets and hit tests.
//
//   TextBox box(font, style, {8, 8, 232, 120}, Align::centre);
//   box.draw("A paragraph that wraps.", painter);
//
// Upright text only: the style must not be turned.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/layout/layout.hpp"
#include "inkcell/painter.hpp"

namespace inkcell {

/// Where the lines stand in the height of a box.
enum class VerticalAlign : uint8_t {
  top,
  middle,   // of the lines
  optical,  // of capitals: from those of the first line to the last baseline
  bottom,
};

/// A place between characters.
struct TextPlace {
  size_t offset = 0;  // in the text
  /// Where a line ends without a space or a line feed, its end and the
  /// beginning of the next line are one offset: the end is meant.
  bool is_line_end = false;
};

/// What a text takes of a box.
struct TextSize {
  Q26_6 width;   // of the longest line [px]
  Q26_6 height;  // of all lines [px]
  size_t lines = 0;
};

/// A rectangle for text. Only what it points to has to outlive it.
///
/// Calls find the lines of the text anew. Where a screen is drawn in many
/// strips, find them once:
///
///   TextLine room[6];
///   Span<const TextLine> lines;
///   INKCELL_TRY(box.lay_out(text, painter, room, lines));
///   box.draw(text, painter, lines);  // for each strip
///
/// `lines` must then be what lay_out() made of the same text, options, width
/// and kind of canvas. Wherever nothing is drawn, the window of the painter's
/// sink does not matter: Painter() will do, but for canvases of 1 and 2 bits,
/// whose text is fitted.
struct TextBox {
  LayoutOptions options;
  /// Where lines stand on the screen, within +-32767 px. Ink may overhang it,
  /// as that of swashes and of accents over the first line; lines that are
  /// wholly above or below it are not drawn.
  Rect rect;
  /// What is outside of it is cut off; by default nothing is. Empty, as in a
  /// static object whose constructor was not run, it is a mistake: assertions
  /// end the program, a report says bad_argument.
  Rect clip = {-32767, -32767, 32767, 32767};
  VerticalAlign vertical = VerticalAlign::top;

  constexpr TextBox() noexcept = default;
  /// Refers to font and style, which must outlive it.
  constexpr TextBox(const Font& font,
                    const Style& style,
                    const Rect& box,
                    Align align = Align::start) noexcept
      : options(font, style), rect(box) {
    options.align = align;
  }
  TextBox(const Font&, const Style&&, const Rect&, Align = {}) = delete;

  /// Finds the lines that are drawn. With an ellipsis these are no more than
  /// the box has room for, at least one; the last one then shows that there is
  /// more. buffer_small: there are more than `out` holds; `lines` is untouched.
  Status lay_out(Text text,
                 const Painter& painter,
                 Span<TextLine> out,
                 Span<const TextLine>& lines) const noexcept;

  /// Draws the lines that meet the sink's window. Cannot fail: it clips.
  void draw(Text text,
            const Painter& painter,
            Span<const TextLine> lines = {}) const noexcept;

  /// The pixels that draw() may touch: the ink with filter, fitting and effect,
  /// and how far it overhangs `rect`. Empty if nothing shows.
  Rect box(Text text,
           const Painter& painter,
           Span<const TextLine> lines = {}) const noexcept;

  /// The advances. A rectangle of that size cuts nothing.
  TextSize measure(Text text,
                   const Painter& painter,
                   Span<const TextLine> lines = {}) const noexcept;

  /// The caret nearest to the middle of a pixel: in the line at its height, or
  /// the first or last one.
  TextPlace hit(Text text,
                const Painter& painter,
                int32_t x,
                int32_t y,
                Span<const TextLine> lines = {}) const noexcept;

  /// The caret at a place: a column as high as the line, at the left edge of
  /// the character that follows, or the right edge if that runs leftwards.
  /// Offsets within a character, or between it and its marks, mean its
  /// beginning; those that an ellipsis hides, the ellipsis; those of spaces
  /// where a line ends, its end.
  Rect caret(Text text,
             const Painter& painter,
             TextPlace place,
             Span<const TextLine> lines = {}) const noexcept;
};

}  // namespace inkcell
