// A picture of a glyph, and its pixels.
#pragma once

#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::detail {

// It stands somewhere. Its bytes may be any, and change
// between two reads.
struct Picture {
  Rect box;
  int32_t scale;
  int32_t width;  // of its own pixels, 1..kMaxSide, as its height
  uint32_t bits;  // of a pixel: 1, 2 or 4
  uint32_t guesses;
  const uint8_t* begin;
  const uint8_t* end;  // of the section
};

// Draws a picture of 1 bit, and one of any. Rows are read to the last one in
// the sink's window.
using DrawPicture = void(const Picture& picture, const Sink& sink) noexcept;
DrawPicture draw_bits;
DrawPicture draw_picture;
// The same where none is magnified, in less code: any picture is read as
// coverage.
DrawPicture draw_bits_as_is;
DrawPicture draw_picture_as_is;

// Draws what may be in the sink's window.
inline void draw_in_window(const Picture& picture,
                           DrawPicture* draw,
                           const Sink& sink) noexcept {
  // Rows below the window are not read.
  if (picture.box.y1 > sink.window.y0) {
    draw(picture, sink);
  }
}

}  // namespace inkcell::detail
