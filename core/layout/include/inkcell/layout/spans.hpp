// Parts of a paragraph that are drawn in their own way: in another colour,
// bolder, underlined or struck through. The text breaks as it does without.
//
//   const TextSpan warning = {10, 17, &kBold, TextSpan::kUnderline};
//   draw_span(box, text, {0, 10}, painter);
//   canvas.set_colour(kRed);
//   draw_span(box, text, warning, painter);
//   canvas.set_colour(kInk);
//   draw_span(box, text, {17}, painter);
//
// A colour up to a pixel, as in karaoke, is a box drawn twice, with a clip that
// ends there and with one that begins there.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/layout/text_box.hpp"

namespace inkcell {

/// Bytes of a text, from the beginning of a character to that of another. A
/// mark belongs to the span of its own bytes, an ellipsis and a hyphen to that
/// of the character before which they stand.
struct TextSpan {
  static constexpr uint8_t kUnderline = 1;
  static constexpr uint8_t kStrikeThrough = 2;

  size_t begin = 0;
  size_t end = SIZE_MAX;
  /// Of the size of the box's style, with another filter, weight or effect;
  /// null: that one. Glyphs of `fallback` have their own, and so have words of
  /// another size (LayoutOptions::spans).
  const Style* style = nullptr;
  /// kUnderline and kStrikeThrough; both are whole pixels high, a 14th of the
  /// size, and take spaces in.
  uint8_t lines = 0;

  constexpr TextSpan() noexcept = default;
  constexpr TextSpan(size_t first,
                     size_t past = SIZE_MAX,
                     const Style* own = nullptr,
                     uint8_t marks = 0) noexcept
      : begin(first), end(past), style(own), lines(marks) {}
};

/// Draws a span of the text of a box, and nothing else of it. `lines` is as in
/// TextBox::draw().
void draw_span(const TextBox& box,
               Text text,
               const TextSpan& span,
               const Painter& painter,
               Span<const TextLine> lines = {}) noexcept;

/// The pixels that it may touch, whatever the window is.
Rect span_box(const TextBox& box,
              Text text,
              const TextSpan& span,
              const Painter& painter,
              Span<const TextLine> lines = {}) noexcept;

}  // namespace inkcell
