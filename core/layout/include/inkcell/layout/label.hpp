// One line of text that scrolls: laid out once, drawn as often as it moves.
//
//   PositionedGlyph room[64];
//   ScrollingLabel label;
//   INKCELL_TRY(ScrollingLabel::make(options, painter, "Now playing: ...",
//                                    {0, 0, 128, 16}, room, label));
//   label.draw(scroll, painter);  // scroll: any number of px
#pragma once

#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/layout/layout.hpp"
#include "inkcell/painter.hpp"

namespace inkcell {

/// A window into a line that is longer, or not. The glyphs, the faces of the
/// options and what these point to must outlive it.
class ScrollingLabel {
 public:
  constexpr ScrollingLabel() noexcept = default;

  /// Lays out the first line of a text, of any length, in the middle of the
  /// height of `window`. The painter is like the one that draws: as in TextBox.
  /// `room`: a glyph for each byte always suffices.
  ///
  /// buffer_small: there are more glyphs. bad_argument: the text is longer than
  /// kMaxLineBytes. `out` is then untouched.
  static Status make(const LayoutOptions& options,
                     const Painter& painter,
                     Text text,
                     const Rect& window,
                     Span<PositionedGlyph> room,
                     ScrollingLabel& out) noexcept;

  /// The width of the line. [px]
  Q26_6 width() const noexcept;

  /// Whether the line is wider than the window.
  bool needs_scrolling() const noexcept;

  /// Draws the line moved to the left by `scroll`. Finds the glyphs in the
  /// window by a binary search: the time does not depend on the others. Cuts
  /// ink at the window, unless the line fits and is not moved.
  void draw(Q26_6 scroll, const Painter& painter) const noexcept;

  /// The same for a line that follows itself without end, `gap` px behind: any
  /// scroll is taken by the sum of both.
  void draw_endless(Q26_6 scroll,
                    Q26_6 gap,
                    const Painter& painter) const noexcept;

 private:
  void draw_in(const Rect& clip,
               Q26_6 scroll,
               const Painter& painter) const noexcept;
  size_t first_from(int32_t x) const noexcept;

  Face face_;
  Span<const Face> fallback_;
  Span<const PositionedGlyph> glyphs_;
  Rect window_;
  Q26_6 baseline_;     // on the screen
  int32_t width_ = 0;  // [font units]
  int32_t reach_ = 0;  // of ink to both sides of a glyph's origin
};

}  // namespace inkcell
