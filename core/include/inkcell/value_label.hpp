// A text that changes in place, such as a measured value: which pixels are to
// be drawn and sent again.
//
//   ValueLabel value(font, style, {16, 150});
//   for (;;) {
//     const Rect changed = value.set(NumberText(read_tenths(), 1), {});
//     INKCELL_TRY(port::run_strips(loop, changed));
//   }
//
// where the loop's `draw` paints the background first, then value.draw(canvas).
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/painter.hpp"

namespace inkcell {

namespace detail {
inline constexpr Font kNoFont;
inline constexpr Style kNoStyle;
}  // namespace detail

/// Keeps its text, and the box of it. Lines of a style that is turned are
/// anchored at their left end.
class ValueLabel {
 public:
  /// The longest text. [bytes]
  static constexpr size_t kMostBytes = 31;

  /// Without a font it draws nothing.
  constexpr ValueLabel() noexcept
      : ValueLabel(detail::kNoFont, detail::kNoStyle, {}) {}
  /// An empty text. Refers to font and style, which must outlive it.
  constexpr ValueLabel(const Font& font,
                       const Style& style,
                       Point origin,
                       Anchor anchor = Anchor::left) noexcept
      : font_(&font), style_(&style), origin_(origin), anchor_(anchor) {}
  ValueLabel(const Font&, const Style&&, Point, Anchor = {}) = delete;

  /// Copies a text; one over kMostBytes is cut after a whole character. Returns
  /// the pixels of the old and of the new text, with filter, fitting and
  /// effect: those to draw and to send. Empty if the text is the same.
  /// `painter` is like the one that draws: one of a canvas of 1 or 2 bits fits
  /// text, one with a cache may draw glyphs up to a pixel off; where neither
  /// is, Painter() will do. Of a sink the window does not matter.
  Rect set(Text text, const Painter& painter) noexcept;

  /// Draws the text where the window meets its box. The background is the
  /// caller's.
  void draw(const Painter& painter) const noexcept;

  Text text() const noexcept { return {bytes_, size_}; }
  /// The pixels of the text.
  const Rect& box() const noexcept { return box_; }

 private:
  Point place(const Painter& painter) const noexcept;

  const Font* font_;
  const Style* style_;
  Point origin_;
  Rect box_;
  Anchor anchor_;
  uint8_t size_ = 0;
  char bytes_[kMostBytes] = {};
};

}  // namespace inkcell
